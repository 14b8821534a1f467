package lightning.editor.window.match;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.editor.window.widget.PictureView;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.match.BrushDab;
import lightning.render.match.PaintedReference;
import org.jspecify.annotations.Nullable;

/**
 * The picture with a reference, of which a region may count alone. Without a reference, a brush paints on it. Double click fits both to the view.
 */
final class MatchView extends HBox {
    /** Share of the paint's color in a painted pixel. */
    private static final double PAINT = 0.35;
    private static final double HALF = 0.5;
    /** Share of black in pixels outside the region. */
    private static final double OUTSIDE = 0.6;
    /** Radius of the brush relative to the width of the picture. */
    private static final double BRUSH = 0.035;

    private final PictureView picture = new PictureView();
    private final PictureView beside = new PictureView();
    private final StackPane besideBox = new StackPane(beside);
    private final List<BrushDab> dabs = new ArrayList<>();
    private final Runnable onPainted;
    private BrushDab.@Nullable Wish brush;
    private @Nullable Film film;
    private ViewTransform view = ViewTransform.DEFAULT;
    private Optional<Shown> reference = Optional.empty();
    private Arrangement arrangement = Arrangement.WIPE;
    private boolean selectsRegion;
    private Optional<MatchRegion> region = Optional.empty();
    /** Start of a drag of the region: column and row. */
    private double[] corner = {0, 0};

    /** Place of the reference. */
    enum Arrangement {
        /** Over the left part of the picture. */
        WIPE(Messages.key("Over the Left Part")),
        SIDE_BY_SIDE(Messages.key("Side by Side")),
        /** Half of each. */
        MIXED(Messages.key("Mixed with the Picture"));

        private final String title;

        Arrangement(String title) {
            this.title = title;
        }

        @Override
        public String toString() {
            return Messages.tr(title);
        }
    }

    /**
     * A reference as it is shown.
     *
     * @param view its view transform; empty for that of the picture
     */
    record Shown(Film film, Optional<ViewTransform> view) {}

    /** @param onPainted runs after each change of the paint */
    MatchView(Runnable onPainted) {
        this.onPainted = onPainted;
        picture.setId("match-picture");
        beside.setId("match-reference");
        var pictureBox = new StackPane(picture);
        for (StackPane box : List.of(besideBox, pictureBox)) {
            box.getStyleClass().add("canvas");
            box.setMinSize(100, 100);
            HBox.setHgrow(box, Priority.ALWAYS);
            // Both halves have the same width, whatever they show.
            box.setPrefWidth(100);
        }
        getChildren().setAll(pictureBox);
        picture.addEventHandler(MouseEvent.MOUSE_PRESSED, e -> {
            picture.pixel(e.getX(), e.getY()).ifPresent(at -> corner = new double[] {at.x(), at.y()});
            drag(e);
        });
        picture.addEventHandler(MouseEvent.MOUSE_DRAGGED, this::drag);
        picture.addEventHandler(MouseEvent.MOUSE_CLICKED, e -> {
            if (e.getClickCount() == 2 && brush == null) {
                picture.fit();
                beside.fit();
            }
        });
    }

    /** Shows a picture. */
    void show(Film newFilm, ViewTransform newView) {
        boolean isFirst = picture.isEmpty();
        film = newFilm;
        view = newView;
        update();
        if (isFirst) {
            picture.fit();
        }
    }

    /** Shows a reference, or none. */
    void setReference(Optional<Shown> newReference) {
        reference = newReference;
        region = Optional.empty();
        update();
        beside.fit();
    }

    void setArrangement(Arrangement v) {
        arrangement = v;
        update();
    }

    /** Lets drags select the region that counts; without it all counts. */
    void setSelectsRegion(boolean v) {
        selectsRegion = v;
        if (!v) {
            region = Optional.empty();
        }
        update();
    }

    /** Returns the only region of the reference that counts; empty if all counts. */
    Optional<MatchRegion> region() {
        return region;
    }

    /** Sets the brush; null for none. */
    void setBrush(BrushDab.@Nullable Wish v) {
        brush = v;
    }

    List<BrushDab> dabs() {
        return List.copyOf(dabs);
    }

    /** Removes all paint. */
    void erase() {
        dabs.clear();
        update();
        onPainted.run();
    }

    private void drag(MouseEvent e) {
        if (e.getButton() != MouseButton.PRIMARY || film == null) {
            return;
        }
        if (selectsRegion && reference.isPresent()) {
            Film shown = film;
            PictureView.Pixel at = picture.nearestPixel(e.getX(), e.getY());
            region = MatchRegion.between(corner[0] / shown.width(), corner[1] / shown.height(), (double) at.x() / shown.width(),
                    (double) at.y() / shown.height());
            update();
        } else if (picture.wipe().isVisible()) {
            picture.wipeTo(e.getX());
        } else if (brush != null && reference.isEmpty()) {
            BrushDab.Wish wish = brush;
            double radius = Math.max(1, BRUSH * film.width());
            picture.pixel(e.getX(), e.getY()).ifPresent(at -> {
                dabs.add(new BrushDab(wish, at.x() + 0.5, at.y() + 0.5, radius));
                update();
                onPainted.run();
            });
        }
    }

    private void update() {
        if (film == null) {
            return;
        }
        int[] pixels = view.toPixels(film);
        if (reference.isEmpty()) {
            paint(pixels, film.width(), film.height());
        }
        int width = film.width();
        int height = film.height();
        reference.ifPresent(shown -> {
            int[] codes = shown.view().orElse(view).toPixels(shown.film());
            if (arrangement == Arrangement.MIXED) {
                mix(pixels, width, height, codes, shown.film());
            }
            picture.wipe().store(shown.film().width(), shown.film().height(), codes);
            beside.setPixels(shown.film().width(), shown.film().height(), codes);
        });
        region.ifPresent(counting -> darken(pixels, width, height, counting));
        picture.setPixels(width, height, pixels);
        picture.wipe().setVisible(reference.isPresent() && arrangement == Arrangement.WIPE && !selectsRegion);
        boolean showsBoth = reference.isPresent() && arrangement == Arrangement.SIDE_BY_SIDE;
        if (showsBoth != getChildren().contains(besideBox)) {
            if (showsBoth) {
                getChildren().addFirst(besideBox);
            } else {
                getChildren().remove(besideBox);
            }
        }
    }

    private static void mix(int[] pixels, int width, int height, int[] codes, Film reference) {
        for (int i = 0; i < pixels.length; i++) {
            int x = i % width * reference.width() / width;
            int y = i / width * reference.height() / height;
            pixels[i] = mixed(pixels[i], codes[y * reference.width() + x], HALF);
        }
    }

    private static void darken(int[] pixels, int width, int height, MatchRegion region) {
        for (int i = 0; i < pixels.length; i++) {
            if (!region.contains((i % width + 0.5) / width, (i / width + 0.5) / height)) {
                pixels[i] = mixed(pixels[i], 0, OUTSIDE);
            }
        }
    }

    private void paint(int[] pixels, int width, int height) {
        if (dabs.isEmpty()) {
            return;
        }
        BrushDab.@Nullable Wish[] wishes = PaintedReference.wishes(width, height, dabs);
        for (int i = 0; i < pixels.length; i++) {
            BrushDab.Wish wish = wishes[i];
            if (wish != null) {
                pixels[i] = mixed(pixels[i], color(wish), PAINT);
            }
        }
    }

    /** Returns the color of the paint, 0xRRGGBB. */
    static int color(BrushDab.Wish wish) {
        return switch (wish) {
            case BRIGHTER -> 0xffffff;
            case DARKER -> 0x000000;
            case WARMER -> 0xff8c1a;
            case COOLER -> 0x3399ff;
            case KEEP -> 0x33cc66;
        };
    }

    private static int mixed(int pixel, int color, double share) {
        int mixed = 0xff;
        for (int shift = 16; shift >= 0; shift -= 8) {
            int from = pixel >> shift & 0xff;
            mixed = mixed << 8 | (int) Math.round(from + share * ((color >> shift & 0xff) - from));
        }
        return mixed;
    }
}
