package lightning.editor.window.traced;

import java.util.Optional;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.beans.binding.Bindings;
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
import javafx.util.Duration;
import lightning.base.text.Messages;
import lightning.document.loop.RenderActivity;
import lightning.document.loop.RenderState;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.Workbench;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.StatusText;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.model.TracedRaster;
import lightning.editor.window.model.ViewActions;
import lightning.editor.window.model.WindowLayout;
import lightning.editor.window.widget.DelayedMessage;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.PaneHeader;
import lightning.editor.window.widget.PictureView;
import lightning.render.image.DifferenceImage;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.measure.Verification;
import lightning.scene.PictureSettings;
import lightning.scene.VisibleState;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignE;

/** Pane of the ray-traced picture, with its badges, its progress and the report on the pixel under the mouse. */
public final class TracedPane extends BorderPane implements AutoCloseable {
    private static final Insets BADGE_INSETS = new Insets(PictureView.MARGIN);
    /** Time for which the size of the pane must stay the same before the picture is traced for it. */
    private static final Duration SIZE_SETTLES = Duration.millis(300);
    private static final double ZOOM_STEP = 1.5;
    /** Empty report with its two lines, so that the picture keeps its size. */
    private static final String NO_PIXEL = " \n ";

    /** Gap between the progress and the card above it, pixels. */
    private static final double CARD_GAP = 4;

    private final StackPane stage = new StackPane();
    /** Pane in the corner of the picture; null if there is none. */
    private @Nullable PictureInset inset;
    private final WindowLayout layout;
    private final SceneEditor editor;
    private final TracedPicture traced;
    private final CommandRegistry commands;
    private final PictureView picture;
    private final Badge pendingBadge;
    private final Badge mirrorsBadge;
    private final Badge lookBadge;
    private final Label pixelLine = new Label(NO_PIXEL);
    private final Tooltip pixelTip = new Tooltip();
    private final Label lightsCard = new Label();
    private final Label promptLabel = new Label();
    private final Label waitingLabel = new Label();
    private final ToggleButton difference = new ToggleButton(Messages.tr("Difference"));
    private final ToggleButton compare = new ToggleButton("", new FontIcon(MaterialDesignC.COMPARE));
    private final StackPane compareBox = new StackPane(compare);
    private final DisabledReason compareReason =
            new DisabledReason(compareBox, compare,
                    Messages.tr("Compare (A/B): snapshot on the left, image on the right; drag to wipe"));
    private final TracedMouse mouse;
    private final ViewActions views;
    private TracedRaster.@Nullable Pixels shownPixels;
    /** Runs when the size of the pane has not changed for a while. */
    private final PauseTransition sizeSettled = new PauseTransition(SIZE_SETTLES);
    /** True once a picture was finished, canceled or failed. Before that, the window's thread is busy. */
    private boolean hasFinalPicture;

    /**
     * For tests.
     *
     * @param scheduler schedules the delayed updates of the badges
     */
    TracedPane(EditorModel model, DelayedMessage.Scheduler scheduler) {
        this(model, createView(), scheduler);
    }

    /**
     * Creates the pane.
     *
     * @param picture view from {@link #createView}, which the pane takes over. It may already show a picture and a note elsewhere in the
     *     window
     */
    public TracedPane(EditorModel model, PictureView picture) {
        this(model, picture, DelayedMessage.Scheduler.FX_THREAD);
    }

    private TracedPane(EditorModel model, PictureView picture, DelayedMessage.Scheduler scheduler) {
        editor = model.editor();
        traced = model.picture();
        commands = model.commands();
        views = model.viewActions();
        this.picture = picture;
        pendingBadge = new Badge("pending", scheduler);
        mirrorsBadge = new Badge("mirrors", scheduler);
        lookBadge = new Badge("look", scheduler);
        layout = model.layout();
        layout.setPictureArea(picture::area);
        sizeSettled.setOnFinished(_ -> traceForPane(model.workbench()));
        layout.workingSizeProperty().subscribe(_ -> sizeSettled.playFromStart());
        picture.layoutBoundsProperty().subscribe(_ -> sizeSettled.playFromStart());
        setId("traced");
        getStyleClass().add("canvas-pane");
        mouse = new TracedMouse(model, picture, this::showPixel);
        commands.setToggle(Command.REGION, mouse.regionProperty());
        commands.setAction(Command.TRACED_FIT, picture::fit);
        commands.setAction(Command.TRACED_ONE_TO_ONE, picture::showActualSize);
        commands.setAction(Command.TRACED_ZOOM_IN, () -> picture.zoomBy(ZOOM_STEP));
        commands.setAction(Command.TRACED_ZOOM_OUT, () -> picture.zoomBy(1 / ZOOM_STEP));
        commands.setAction(Command.PICK_MATERIAL,
                () -> mouse.pickNext(Messages.tr("Click an object to edit its material"),
                        report -> {
                            if (report.face().isEmpty()) {
                                model.materials().chooseForShape(report.shape());
                            } else {
                                editor.message().show(Messages.tr("No object here"));
                            }
                        }));
        mirrorsBadge.setTooltip(new Tooltip(
                Messages.tr("Reflections are updated on request in this accuracy mode.\nClick to update them (F6).")));
        mirrorsBadge.setOnMouseClicked(_ -> commands.run(Command.UPDATE_REFLECTIONS));
        var badges = new VBox(pendingBadge, mirrorsBadge);
        badges.getStyleClass().add("badges");
        badges.setPickOnBounds(false);
        badges.setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        StackPane.setAlignment(badges, Pos.TOP_LEFT);
        StackPane.setMargin(badges, BADGE_INSETS);
        lookBadge.getStyleClass().add("look-badge");
        lookBadge.setTooltip(
                new Tooltip(Messages.tr("View settings change only the display.\nSave Image and Verify ignore them.")));
        lookBadge.setMaxHeight(Region.USE_PREF_SIZE);
        StackPane.setAlignment(lookBadge, Pos.TOP_RIGHT);
        StackPane.setMargin(lookBadge, BADGE_INSETS);
        var progress = new ProgressOverlay(commands, traced, model.fileActivity());
        StackPane.setAlignment(progress, Pos.BOTTOM_CENTER);
        // Above the progress, which would cover the card's last lines in a narrow pane.
        lightsCard.translateYProperty().bind(Bindings.createDoubleBinding(() -> !progress.isVisible() ? 0
                : Math.min(0, progress.getLayoutY() - CARD_GAP - lightsCard.getLayoutY() - lightsCard.getHeight()),
                progress.visibleProperty(), progress.layoutYProperty(), lightsCard.layoutYProperty(), lightsCard.heightProperty()));
        lightsCard.setId("pixel-lights");
        lightsCard.getStyleClass().add("pixel-card");
        lightsCard.setMouseTransparent(true);
        lightsCard.visibleProperty().bind(lightsCard.textProperty().isNotEmpty());
        StackPane.setAlignment(lightsCard, Pos.BOTTOM_LEFT);
        waitingLabel.setId("waiting");
        waitingLabel.getStyleClass().add("canvas-note");
        waitingLabel.visibleProperty().bind(picture.emptyProperty());
        promptLabel.setId("prompt");
        promptLabel.getStyleClass().add("prompt");
        promptLabel.setMouseTransparent(true);
        promptLabel.textProperty().bind(mouse.promptProperty().map(p -> p.isEmpty() ? "" : Messages.tr("{0}  ·  Esc to finish", p)));
        promptLabel.visibleProperty().bind(mouse.promptProperty().isNotEmpty());
        promptLabel.managedProperty().bind(promptLabel.visibleProperty());
        var notes = new VBox(promptLabel, new PictureMessage(editor.message().textProperty()));
        notes.getStyleClass().add("picture-notes");
        notes.setMouseTransparent(true);
        notes.setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        StackPane.setAlignment(notes, Pos.TOP_CENTER);
        Node legend = new StopLegend(traced.viewProperty());
        StackPane.setAlignment(legend, Pos.BOTTOM_RIGHT);
        StackPane.setMargin(legend, BADGE_INSETS);
        Node clipping = new ClippingLegend(traced.viewProperty());
        StackPane.setAlignment(clipping, Pos.BOTTOM_RIGHT);
        StackPane.setMargin(clipping, BADGE_INSETS);
        var view = traced.viewProperty();
        commands.setToggle(Command.MARK_CLIPPING, view.map(ViewTransform::marksClipping),
                () -> view.set(view.get().withMarksClipping(!view.get().marksClipping())));
        stage.getChildren().setAll(waitingLabel, picture, mouse.overlay(), badges, lookBadge, lightsCard, legend, clipping, progress,
                notes);
        stage.getStyleClass().add("canvas");
        setTop(header());
        setCenter(stage);
        pixelLine.setId("pixel");
        pixelLine.getStyleClass().add("pane-footer");
        pixelLine.setMaxWidth(Double.MAX_VALUE);
        pixelLine.hoverProperty().subscribe(_ -> clearPixel());
        setBottom(pixelLine);
        difference.setId("difference");
        difference.selectedProperty().subscribe(_ -> repaint());
        traced.repaintsProperty().subscribe(_ -> repaint());
        editor.editorStateProperty().subscribe(_ -> updateBadges());
        traced.renderStateProperty().subscribe(_ -> updateBadges());
        picture.showNote("");
    }

    /** Shows a pane as an inset of the picture, or none. */
    public void setInset(@Nullable Region pane) {
        if (inset != null) {
            stage.getChildren().remove(inset);
            inset = null;
        }
        if (pane != null) {
            inset = new PictureInset(pane, stage, editor.sceneProperty().map(scene -> aspect(scene.picture())), layout.insetPlaceProperty(),
                    commands);
            stage.getChildren().add(stage.getChildren().indexOf(mouse.overlay()) + 1, inset);
        }
    }

    private static double aspect(PictureSettings picture) {
        return (double) picture.width() / picture.height();
    }

    /** Creates the view of the picture. */
    public static PictureView createView() {
        var view = new PictureView();
        view.setId("traced-picture");
        return view;
    }

    /** Returns the note on a coarse preview, which is shown before the first full picture. */
    public static String coarseNote() {
        return StatusText.stage(RenderActivity.Stage.CENTERS);
    }

    private Node header() {
        var zoom = new HBox(CommandButton.iconButton(commands, Command.TRACED_FIT),
                CommandButton.iconButton(commands, Command.TRACED_ONE_TO_ONE));
        zoom.setAlignment(Pos.CENTER);
        var exposure = new ExposureControl(views, editor.message());
        return new PaneHeader(Messages.tr("Ray traced"), difference, CommandButton.iconButton(commands, Command.ONLY_SELECTED), snapshot(),
                compareBox,
                exposure, viewMenu(),
                CommandButton.iconButton(commands, Command.REGION),
                CommandButton.iconButton(commands, Command.MOVE_CAMERA),
                zoom).withNarrow(ExposureControl.NARROW_SAVING, exposure::setNarrow).withOptional(zoom)
                .withNarrow(ExposureControl.SLIDER_SAVING, exposure::setSliderHidden);
    }

    private MenuButton viewMenu() {
        var menu = new MenuButton("", new FontIcon(MaterialDesignE.EYE_SETTINGS_OUTLINE));
        menu.setId("view-options");
        menu.setAccessibleText(Messages.tr("View Options"));
        menu.setTooltip(
                new Tooltip(Messages.tr("View transform of the scene, analysis views and visible effects")));
        menu.getStyleClass().addAll("button-icon", "flat");
        menu.getItems().setAll(ViewMenuItems.of(views, CommandMenuItems.forMenu(commands, "view-")));
        return menu;
    }

    private Button snapshot() {
        var button = new Button("", new FontIcon(MaterialDesignC.CAMERA_OUTLINE));
        button.setId("snapshot");
        button.setAccessibleText(Messages.tr("Snapshot"));
        button.getStyleClass().add("button-icon");
        button.setTooltip(new Tooltip(Messages.tr("Snapshot\nSave the current image for comparison.")));
        button.setOnAction(_ -> storeSnapshot());
        compare.setId("compare");
        compare.setAccessibleText(Messages.tr("Compare"));
        compare.getStyleClass().add("button-icon");
        compareReason.set(Optional.of(Messages.tr("no snapshot yet")));
        compare.selectedProperty().subscribe(on -> {
            picture.wipe().setVisible(on);
            picture.requestLayout();
        });
        return button;
    }

    private void storeSnapshot() {
        TracedRaster.Pixels pixels = traced.raster().pixels();
        if (pixels != null) {
            picture.wipe().store(pixels.width(), pixels.height(), pixels.pixels());
            compareReason.set(Optional.empty());
            picture.requestLayout();
            editor.message().show(Messages.tr("Snapshot saved"));
        }
    }

    /**
     * Shows the report on a pixel.
     *
     * @param report report on the pixel under the mouse; null if there is none
     */
    private void showPixel(@Nullable PixelReport report) {
        lightsCard.setText(report == null ? "" : String.join("\n", report.lightLines()));
        if (report == null) {
            // Deferred until the mouse's new target is known.
            Platform.runLater(this::clearPixel);
            return;
        }
        pixelLine.setText(report.headline(traced.frame() == null ? ""
                : PixelValues.text(traced.frame().displayed(), traced.viewProperty().get(), report.x(), report.y())));
        pixelTip.setText(pixelLine.getText());
        pixelLine.setTooltip(pixelTip);
    }

    /** Keeps the last report while the mouse is over the report itself: its tooltip shows the text that does not fit. */
    private void clearPixel() {
        if (!pixelLine.isHover() && lightsCard.getText().isEmpty()) {
            pixelLine.setText(NO_PIXEL);
            pixelLine.setTooltip(null);
        }
    }

    /** Returns whether no picture is shown yet. */
    public boolean isEmpty() {
        return picture.emptyProperty().get();
    }

    /** Describes how the picture differs from the edited scene; empty if it is up to date. */
    private String pendingText() {
        EditorState state = editor.editorStateProperty().get();
        if (traced.raster().isPatched() && mouse.patchedScene() != null && state.renderedScene().isPresent()
                && !VisibleState.isSame(mouse.patchedScene(), state.renderedScene().get())) {
            return VisibleState.isSame(mouse.patchedScene(), state.scene()) ? Messages.tr("The region is newer than the rest of the image")
                    : Messages.tr("The region is out of date");
        }
        if (traced.raster().pixels() == null) {
            return "";
        }
        if (state.lacksIndirectLight()) {
            return isStopped() ? Messages.tr("Direct light only. Render (F5)") : Messages.tr("Direct light only");
        }
        if (state.frame().isEmpty() || state.hasPendingEdits() && traced.raster().isUnfinished()) {
            return isStopped() ? Messages.tr("Unfinished. Render (F5)") : coarseNote();
        }
        if (state.pendingMessage().isEmpty()) {
            return "";
        }
        boolean isInProgress = state.sceneInProgress().filter(s -> VisibleState.isSame(s, state.scene())).isPresent();
        return state.hasPendingEdits() ? isInProgress ? coarseNote() : Messages.tr("Out of date. Render (F5)")
                : state.sceneInProgress().isPresent() ? StatusText.stage(RenderActivity.Stage.SAMPLES)
                : Messages.tr("Not anti-aliased");
    }

    /** Returns whether the last render was canceled or failed, and no other one is running. */
    private boolean isStopped() {
        RenderState state = traced.renderStateProperty().get();
        return editor.editorStateProperty().get().sceneInProgress().isEmpty() && (state.canceled() || state.problem() != null);
    }

    /** Returns the text shown while there is no picture. */
    private String waitingText() {
        RenderState state = traced.renderStateProperty().get();
        if (state.problem() != null) {
            return ErrorMessage.of(state.problem());
        }
        return state.canceled() ? Messages.tr("Canceled. Render the image with F5.")
                : Messages.tr("Tracing {0} …", editor.document().name());
    }

    private void showPending(String text) {
        RenderState state = traced.renderStateProperty().get();
        hasFinalPicture |= state.frame() != null && state.frame().isFinished() || state.canceled() || state.problem() != null;
        if (hasFinalPicture) {
            pendingBadge.setMessage(text);
        } else {
            pendingBadge.setMessageImmediately(text);
        }
    }

    /** Traces the picture for the size of the pane, unless the pane is hidden. */
    private void traceForPane(Workbench workbench) {
        if (picture.getWidth() > 1 && picture.getHeight() > 1) {
            workbench.setArea(layout.workingSizeProperty().get().area(picture.area()));
        }
    }

    private void updateBadges() {
        waitingLabel.setText(waitingText());
        showPending(pendingText());
        var frame = traced.renderStateProperty().get().frame();
        String lookLabel = frame == null ? "" : frame.displayMode().label();
        lookBadge.setMessage(lookLabel.isEmpty() ? "" : Messages.tr("View: {0}", lookLabel));
        boolean isStale = frame != null && frame.isDisplayStale();
        mirrorsBadge.setMessage(isStale
                ? editor.editorStateProperty().get().staleMirrorsMessage().map(r -> Messages.tr("{0}. Click to update", r)).orElse("")
                : "");
        boolean isVerified = currentVerification() != null;
        difference.setVisible(isVerified);
        difference.setManaged(isVerified);
        if (!isVerified) {
            difference.setSelected(false);
        }
    }

    /** Returns the last verification if it refers to the displayed picture; otherwise null. */
    private @Nullable Verification currentVerification() {
        var state = traced.renderStateProperty().get();
        boolean matches = state.verification() != null && state.frame() != null
                && state.verification().appliesTo(state.frame().guarantee());
        return matches ? state.verification() : null;
    }

    private void repaint() {
        var verification = difference.isSelected() ? currentVerification() : null;
        if (verification != null) {
            Film film = DifferenceImage.of(verification.picture(), verification.full());
            picture.setPixels(film.width(), film.height(), ViewTransform.DEFAULT.toPixels(film));
            shownPixels = null;
            return;
        }
        TracedRaster.Pixels pixels = traced.raster().pixels();
        TracedRaster.DirtyRect dirty = traced.raster().takeDirty();
        if (pixels == null) {
            picture.clear();
            shownPixels = null;
            return;
        }
        if (pixels != shownPixels) {
            picture.setPixels(pixels.width(), pixels.height(), pixels.pixels());
            shownPixels = pixels;
        } else if (!dirty.isEmpty()) {
            picture.updateRegion(dirty.left(), dirty.top(), dirty.right(), dirty.bottom());
        }
        updateBadges();
    }

    TracedMouse mouse() {
        return mouse;
    }

    @Override
    public void close() {
        sizeSettled.stop();
        mouse.close();
    }
}
