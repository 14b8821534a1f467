package lightning.editor.window.traced;

import java.util.Optional;
import javafx.application.Platform;
import javafx.geometry.Insets;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Texts;
import lightning.bench.accuracy.Verification;
import lightning.editor.document.Command;
import lightning.editor.document.Situation;
import lightning.editor.loop.RenderState;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.model.TracedRaster;
import lightning.editor.window.widget.Lasting;
import lightning.editor.window.widget.Obstacle;
import lightning.editor.window.widget.PaneHeader;
import lightning.editor.window.widget.PictureView;
import lightning.render.image.DifferencePicture;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.VisiblePart;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignE;

/** The ray-traced canvas: the picture, what it does not show yet, how far it is, and what a pixel of it is made of. */
public final class TracedPane extends BorderPane implements AutoCloseable {
    private static final Insets BADGES = new Insets(PictureView.MARGIN);
    private static final double ZOOM = 1.5;
    /** As many lines as are told of a pixel, so that the picture keeps its room. */
    private static final String NO_PIXEL = " \n ";

    private final SceneEditor editor;
    private final TracedPicture traced;
    private final Commands commands;
    private final PictureView picture;
    private final Badge pending;
    private final Badge mirrors;
    private final Badge look;
    private final Label pixelLine = new Label(NO_PIXEL);
    private final Tooltip pixelTip = new Tooltip();
    private final Label card = new Label();
    private final Label prompt = new Label();
    private final Label waiting = new Label();
    private final ToggleButton difference = new ToggleButton(Texts.of("Difference"));
    private final ToggleButton compare = new ToggleButton("", new FontIcon(MaterialDesignC.COMPARE));
    private final StackPane compareBox = new StackPane(compare);
    private final Obstacle comparing =
            new Obstacle(compareBox, compare, Texts.of("Compare: the snapshot on the left, the picture on the right; drag to wipe"));
    private final TracedMouse mouse;
    private TracedRaster.Pixels shown;
    /** Whether there was a picture with all its samples, or none will be: before, the window's thread has much to do. */
    private boolean begun;

    /** @param later when badges are looked at again */
    TracedPane(EditorModel model, Lasting.Later later) {
        this(model, view(), later);
    }

    /**
     * @param picture shows the picture from now on; a {@link #view}, which may show something already, elsewhere in the window, and say
     *                so: the pane says it then
     */
    public TracedPane(EditorModel model, PictureView picture) {
        this(model, picture, Lasting.Later.WINDOW);
    }

    private TracedPane(EditorModel model, PictureView picture, Lasting.Later later) {
        editor = model.editor();
        traced = model.picture();
        commands = model.commands();
        this.picture = picture;
        pending = new Badge("pending", later);
        mirrors = new Badge("mirrors", later);
        look = new Badge("look", later);
        setId("traced");
        getStyleClass().add("canvas-pane");
        mouse = new TracedMouse(model, picture, this::tell);
        commands.setSwitch(Command.REGION, mouse.regionProperty());
        commands.setAction(Command.TRACED_FIT, picture::fit);
        commands.setAction(Command.TRACED_ONE_TO_ONE, picture::oneToOne);
        commands.setAction(Command.TRACED_ZOOM_IN, () -> picture.zoomBy(ZOOM));
        commands.setAction(Command.TRACED_ZOOM_OUT, () -> picture.zoomBy(1 / ZOOM));
        commands.setAction(Command.PICK_MATERIAL,
                () -> mouse.pickNext(Texts.of("Click the shape whose material to edit"), at -> model.materials().chooseOf(at.shape())));
        mirrors.setTooltip(new Tooltip(Texts.of("As in 1998, mirrors are updated on demand.\nA click here does it, and F6.")));
        mirrors.setOnMouseClicked(_ -> commands.run(Command.UPDATE_REFLECTIONS));
        var badges = new VBox(pending, mirrors);
        badges.getStyleClass().add("badges");
        badges.setPickOnBounds(false);
        badges.setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        StackPane.setAlignment(badges, Pos.TOP_LEFT);
        StackPane.setMargin(badges, BADGES);
        look.getStyleClass().add("look-badge");
        look.setTooltip(new Tooltip(Texts.of("A way of looking, no part of the scene.\nSave Image and Verify take the picture itself.")));
        look.setMaxHeight(Region.USE_PREF_SIZE);
        StackPane.setAlignment(look, Pos.TOP_RIGHT);
        StackPane.setMargin(look, BADGES);
        Node progress = new ProgressOverlay(commands, traced, model.fileWork());
        StackPane.setAlignment(progress, Pos.BOTTOM_CENTER);
        card.setId("pixel-lights");
        card.getStyleClass().add("pixel-card");
        card.setMouseTransparent(true);
        card.visibleProperty().bind(card.textProperty().isNotEmpty());
        StackPane.setAlignment(card, Pos.BOTTOM_LEFT);
        waiting.setId("waiting");
        waiting.getStyleClass().add("canvas-note");
        waiting.visibleProperty().bind(picture.emptyProperty());
        prompt.setId("prompt");
        prompt.getStyleClass().add("prompt");
        prompt.setMouseTransparent(true);
        prompt.textProperty().bind(mouse.promptProperty().map(p -> p.isEmpty() ? "" : Texts.of("{0}  ·  Esc ends", p)));
        prompt.visibleProperty().bind(mouse.promptProperty().isNotEmpty());
        StackPane.setAlignment(prompt, Pos.TOP_CENTER);
        Node legend = new StopLegend(traced.viewProperty());
        StackPane.setAlignment(legend, Pos.BOTTOM_RIGHT);
        StackPane.setMargin(legend, BADGES);
        Node clipping = new ClippingLegend(traced.viewProperty());
        StackPane.setAlignment(clipping, Pos.BOTTOM_RIGHT);
        StackPane.setMargin(clipping, BADGES);
        var view = traced.viewProperty();
        commands.setSwitch(Command.MARK_CLIPPING, view.map(ViewTransform::marked),
                () -> view.set(view.get().withMarked(!view.get().marked())));
        var stage = new StackPane(waiting, picture, mouse.overlay(), badges, look, card, legend, clipping, progress, prompt);
        stage.getStyleClass().add("canvas");
        setTop(header());
        setCenter(stage);
        pixelLine.setId("pixel");
        pixelLine.getStyleClass().add("pane-footer");
        pixelLine.setMaxWidth(Double.MAX_VALUE);
        setOnMouseExited(_ -> forgetPixel());
        setBottom(pixelLine);
        difference.setId("difference");
        difference.selectedProperty().subscribe(_ -> repaint());
        traced.repaintsProperty().subscribe(_ -> repaint());
        editor.situationProperty().subscribe(_ -> mark());
        traced.renderingProperty().subscribe(_ -> mark());
        picture.say("");
    }

    /** What shows the picture. */
    public static PictureView view() {
        var view = new PictureView();
        view.setId("traced-picture");
        return view;
    }

    /** What is said of a coarse picture, which is there before the first whole one. */
    public static String coarse() {
        return Texts.of("Coarse picture, a finer one follows");
    }

    private Node header() {
        var zoom = new HBox(CommandButton.icon(commands, Command.TRACED_FIT), CommandButton.icon(commands, Command.TRACED_ONE_TO_ONE));
        zoom.setAlignment(Pos.CENTER);
        return new PaneHeader(Texts.of("Ray traced"), difference, CommandButton.icon(commands, Command.ONLY_SELECTED), snapshot(),
                compareBox,
                new ExposureControl(traced.viewProperty(), editor.message()), viewMenu(), CommandButton.icon(commands, Command.REGION),
                zoom);
    }

    private MenuButton viewMenu() {
        var menu = new MenuButton("", new FontIcon(MaterialDesignE.EYE_SETTINGS_OUTLINE));
        menu.setId("view-options");
        menu.setAccessibleText(Texts.of("How the picture is shown"));
        menu.setTooltip(new Tooltip(Texts.of("How the picture is shown\nThe display's curve, and effects to hide. No part of the scene.")));
        menu.getStyleClass().addAll("button-icon", "flat");
        menu.getItems().setAll(ViewItems.of(traced.viewProperty(), CommandItems.of(commands, "view-")));
        return menu;
    }

    private Button snapshot() {
        var button = new Button("", new FontIcon(MaterialDesignC.CAMERA_OUTLINE));
        button.setId("snapshot");
        button.setAccessibleText(Texts.of("Snapshot"));
        button.getStyleClass().add("button-icon");
        button.setTooltip(new Tooltip(Texts.of("Snapshot\nKeep this picture to compare later ones with.")));
        button.setOnAction(_ -> store());
        compare.setId("compare");
        compare.setAccessibleText(Texts.of("Compare"));
        compare.getStyleClass().add("button-icon");
        comparing.set(Optional.of(Texts.of("no snapshot is kept yet")));
        compare.selectedProperty().subscribe(on -> {
            picture.wipe().setVisible(on);
            picture.requestLayout();
        });
        return button;
    }

    private void store() {
        TracedRaster.Pixels pixels = traced.raster().pixels();
        if (pixels != null) {
            picture.wipe().store(pixels.width(), pixels.height(), pixels.pixels());
            comparing.set(Optional.empty());
            picture.requestLayout();
            editor.message().show(Texts.of("Snapshot kept"));
        }
    }

    /** @param report what the pixel under the mouse shows; null where there is none */
    private void tell(PixelReport report) {
        card.setText(report == null ? "" : String.join("\n", report.lightLines()));
        if (report == null) {
            // Once it is known what the mouse is over instead.
            Platform.runLater(this::forgetPixel);
            return;
        }
        pixelLine.setText(report.headline(traced.frame() == null ? ""
                : PixelValues.text(traced.frame().seen(), traced.viewProperty().get(), report.x(), report.y())));
        pixelTip.setText(pixelLine.getText());
        pixelLine.setTooltip(pixelTip);
    }

    /** What was told of the last pixel stays while the mouse is on its way to it: its tooltip has what the line has no room for. */
    private void forgetPixel() {
        if (!isHover() && card.getText().isEmpty()) {
            pixelLine.setText(NO_PIXEL);
            pixelLine.setTooltip(null);
        }
    }

    /** Whether there is no picture in it yet. */
    public boolean isEmpty() {
        return picture.emptyProperty().get();
    }

    /** How the picture is behind the edits; empty where it is not. */
    private String remark() {
        Situation now = editor.situationProperty().get();
        if (traced.raster().isPatched() && mouse.patched() != null && now.rendered().isPresent()
                && !VisiblePart.same(mouse.patched(), now.rendered().get())) {
            return VisiblePart.same(mouse.patched(), now.scene()) ? Texts.of("A region shows edits that the rest does not")
                    : Texts.of("A region shows other edits than the rest");
        }
        if (now.frame().isEmpty()) {
            return traced.raster().pixels() == null ? "" : coarse();
        }
        // What is played is always on its way.
        boolean comes = now.animating() && now.inWork().isPresent();
        if (comes || now.pendingRemark().isEmpty()) {
            return "";
        }
        return now.isPending() ? Texts.of("Edits not yet rendered") : now.inWork().isPresent() ? Texts.of("Finer samples follow")
                : Texts.of("Without finer samples");
    }

    /** What is said in the place of a picture that is not there yet. */
    private String waiting() {
        RenderState state = traced.renderingProperty().get();
        if (state.problem() != null) {
            return Sentence.of(state.problem());
        }
        return state.cancelled() ? Texts.of("Cancelled. Go traces the picture.") : Texts.of("Tracing {0} …", editor.document().name());
    }

    private void tellPending(String remark) {
        RenderState state = traced.renderingProperty().get();
        begun |= state.frame() != null && state.frame().finished() || state.cancelled() || state.problem() != null;
        if (begun) {
            pending.tell(remark);
        } else {
            pending.tellAtOnce(remark);
        }
    }

    private void mark() {
        waiting.setText(waiting());
        tellPending(remark());
        var frame = traced.renderingProperty().get().frame();
        String shown = frame == null ? "" : frame.look().label();
        look.tell(shown.isEmpty() ? "" : Texts.of("View: {0}", shown));
        boolean stale = frame != null && frame.looksStale();
        mirrors.tell(stale ? editor.situationProperty().get().mirrorsRemark().map(r -> Texts.of("{0}: Update Reflections", r)).orElse("")
                : "");
        boolean verified = verified() != null;
        difference.setVisible(verified);
        difference.setManaged(verified);
        if (!verified) {
            difference.setSelected(false);
        }
    }

    /** The difference picture's films, where the last verification is of the picture shown; else null. */
    private Verification verified() {
        var state = traced.renderingProperty().get();
        boolean fits = state.verification() != null && state.frame() != null
                && state.verification().speaksOf(state.frame().promise());
        return fits ? state.verification() : null;
    }

    private void repaint() {
        var verification = difference.isSelected() ? verified() : null;
        if (verification != null) {
            Film film = DifferencePicture.of(verification.picture(), verification.full());
            picture.setPixels(film.width(), film.height(), ViewTransform.DEFAULT.toPixels(film));
            shown = null;
            return;
        }
        TracedRaster.Pixels pixels = traced.raster().pixels();
        TracedRaster.Dirty dirty = traced.raster().takeDirty();
        if (pixels == null) {
            picture.clear();
            shown = null;
            return;
        }
        if (pixels != shown) {
            picture.setPixels(pixels.width(), pixels.height(), pixels.pixels());
            shown = pixels;
        } else if (!dirty.isEmpty()) {
            picture.changed(dirty.left(), dirty.top(), dirty.right(), dirty.bottom());
        }
        mark();
    }

    @Override
    public void close() {
        mouse.close();
    }
}
