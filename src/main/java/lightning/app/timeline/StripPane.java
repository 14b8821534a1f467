package lightning.app.timeline;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.image.ImageView;
import javafx.scene.input.MouseButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Pane;
import javafx.scene.layout.StackPane;
import javafx.util.Subscription;
import lightning.app.model.EditorModel;
import lightning.app.widget.PixelImage;
import lightning.edit.Situation;
import lightning.scene.Picture;
import lightning.scene.shot.Shot;
import lightning.shot.FrameState;
import lightning.text.Texts;
import lightning.work.Memory;

/** The film strip below the keys: frames as small pictures, as many as have room; a click goes to the frame. Nothing is kept before it is asked. */
final class StripPane extends StackPane implements AutoCloseable {
    static final double HEIGHT = 64;
    private static final PseudoClass STALE = PseudoClass.getPseudoClass("stale");
    private static final PseudoClass FAILED = PseudoClass.getPseudoClass("failed");
    private static final PseudoClass HERE = PseudoClass.getPseudoClass("here");
    private static final double MEGABYTE = 1e6;

    private final EditorModel model;
    private final Timeline timeline;
    private final Pane slots = new Pane();
    private final Label cost = new Label();
    private final Label progress = new Label();
    private final HBox question;
    private final Button begin = new Button(Texts.of("Keep the Frames"));
    private final List<Slot> shown = new ArrayList<>();
    private final Subscription following;
    private FilmStrip strip;

    /** One picture, at its place. */
    private static final class Slot extends StackPane {
        private final ImageView image = new ImageView();
        private final Label number = new Label();
        private int frame = -1;
        private int[] pixels;

        Slot() {
            getStyleClass().add("strip-slot");
            number.getStyleClass().add("strip-number");
            image.setPreserveRatio(true);
            image.setFitHeight(HEIGHT);
            setAlignment(number, Pos.BOTTOM_LEFT);
            getChildren().addAll(image, number);
            setManaged(false);
        }
    }

    StripPane(EditorModel model, Timeline timeline) {
        this.model = model;
        this.timeline = timeline;
        setId("strip");
        getStyleClass().add("film-strip");
        setMinHeight(HEIGHT + 4);
        setMaxHeight(HEIGHT + 4);
        cost.setId("strip-cost");
        cost.getStyleClass().add("pane-note");
        cost.setWrapText(true);
        begin.setId("strip-begin");
        begin.setMinWidth(USE_PREF_SIZE);
        begin.setOnAction(_ -> begin());
        question = new HBox(cost, begin);
        question.getStyleClass().add("no-shot");
        progress.setId("strip-progress");
        progress.getStyleClass().add("strip-progress");
        progress.setMouseTransparent(true);
        setAlignment(progress, Pos.TOP_RIGHT);
        getChildren().addAll(slots, progress, question);
        slots.setOnMouseClicked(e -> {
            if (e.getButton() == MouseButton.PRIMARY && !model.isAnimating()) {
                shown.stream().filter(s -> s.getBoundsInParent().contains(e.getX(), e.getY())).findFirst()
                        .ifPresent(s -> model.showFrame(s.frame));
            }
        });
        following = Subscription.combine(timeline.scaleProperty().subscribe(_ -> draw()),
                model.situationProperty().subscribe(this::follow),
                model.viewProperty().subscribe(v -> {
                    if (strip != null) {
                        strip.setView(v.ofPicture());
                    }
                }));
    }

    private void begin() {
        model.moment().ifPresent(now -> {
            strip = new FilmStrip(now.shot(), model.document().content().still(), model.viewProperty().get().ofPicture(), model.window(),
                    this::draw);
            follow(model.situationProperty().get());
        });
    }

    /** Lets go of all frames, and hears no more. */
    @Override
    public void close() {
        following.unsubscribe();
        end();
    }

    private void end() {
        if (strip != null) {
            strip.close();
            strip = null;
        }
        draw();
    }

    private void follow(Situation now) {
        Optional<Shot> shot = now.moment().map(m -> m.shot());
        if (strip != null && shot.filter(strip::isOf).isEmpty()) {
            // Other frames take other room: that is asked anew.
            end();
        }
        if (strip != null && !model.isAnimating()) {
            strip.setUrgent(now.inWork().isPresent() || now.verifying());
            strip.show(model.document().content(), now.moment().orElseThrow().frame());
        }
        if (strip == null) {
            shot.ifPresent(this::ask);
        }
        question.setVisible(strip == null);
        draw();
    }

    private void ask(Shot shot) {
        long bytes = FilmStrip.bytes(model.document().content().still(), shot);
        boolean fits = bytes <= Memory.available() / 2;
        cost.setText(Texts.of("The strip keeps {0} small frames and relights them after each edit: at most {1} MB of memory.",
                (long) shot.last() - shot.first() + 1, Math.max(1, Math.round(bytes / MEGABYTE)))
                + (fits ? "" : " " + Texts.of("That is more than there is for it.")));
        begin.setDisable(!fits);
    }

    private void draw() {
        if (strip == null || timeline.shotProperty().get() == null || !strip.isOf(timeline.shotProperty().get())) {
            slots.getChildren().clear();
            shown.clear();
            progress.setText("");
            return;
        }
        Shot shot = timeline.shotProperty().get();
        FrameScale scale = timeline.scaleProperty().get();
        Picture picture = FilmStrip.small(model.document().content().still()).picture();
        double width = Math.max(8, HEIGHT * picture.width() / picture.height()) + 2;
        List<Place> places = places(shot, scale, width);
        while (shown.size() < places.size()) {
            var slot = new Slot();
            shown.add(slot);
            slots.getChildren().add(slot);
        }
        while (shown.size() > places.size()) {
            slots.getChildren().remove(shown.removeLast());
        }
        int here = model.moment().map(m -> m.frame()).orElse(-1);
        for (int i = 0; i < places.size(); i++) {
            show(shown.get(i), places.get(i), width, nearest(places, here));
        }
        int current = 0;
        for (int frame = shot.first(); frame <= shot.last(); frame++) {
            current += strip.state(frame) == FrameState.CURRENT ? 1 : 0;
        }
        int all = shot.last() - shot.first() + 1;
        progress.setText(current == all ? "" : Texts.of("{0} of {1} frames", current, all));
    }

    /**
     * A frame and where its picture begins.
     *
     * @param x pixels behind the names
     */
    private record Place(int frame, double x) {}

    private static int nearest(List<Place> places, int here) {
        return places.stream().map(Place::frame).min((a, b) -> Integer.compare(Math.abs(a - here), Math.abs(b - here))).orElse(-1);
    }

    /** Those that have room beside each other, each about its frame, from the first of the shot that is seen on. */
    private static List<Place> places(Shot shot, FrameScale scale, double width) {
        List<Place> all = new ArrayList<>();
        double free = 0;
        int frame = Math.max(shot.first(), scale.frame(0));
        while (frame <= shot.last() && scale.shows(frame)) {
            double x = Math.max(0, Math.min(scale.x(frame) - width / 2, scale.width() - width));
            if (x >= free) {
                all.add(new Place(frame, x));
                free = x + width;
            }
            frame = Math.max(frame + 1, scale.frame(free + width / 2));
        }
        return all;
    }

    private void show(Slot slot, Place place, double width, int here) {
        int frame = place.frame();
        slot.frame = frame;
        slot.setId("strip-" + frame);
        slot.number.setText(String.valueOf(frame));
        FrameState state = strip.state(frame);
        slot.pseudoClassStateChanged(STALE, state == FrameState.STALE || state == FrameState.MISSING);
        slot.pseudoClassStateChanged(FAILED, state == FrameState.FAILED);
        slot.pseudoClassStateChanged(HERE, frame == here);
        int[] pixels = strip.picture(frame).map(FilmStrip.Small::pixels).orElse(null);
        if (pixels != slot.pixels) {
            slot.pixels = pixels;
            slot.image.setImage(strip.picture(frame).map(p -> PixelImage.of(p.width(), p.height(), p.pixels())).orElse(null));
        }
        slot.setAccessibleText(Texts.of("frame {0}", frame));
        slot.resizeRelocate(TrackCell.NAME + place.x(), 2, width - 2, HEIGHT);
    }
}
