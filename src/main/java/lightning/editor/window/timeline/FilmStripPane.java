package lightning.editor.window.timeline;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;
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
import javafx.scene.layout.VBox;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.editor.EditorState;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.PixelImage;
import lightning.render.image.Film;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.shot.FrameState;
import org.jspecify.annotations.Nullable;

/** Film strip below the keyframes, with as many thumbnails as fit. A click goes to the frame. Caches no frames until the user starts it. */
final class FilmStripPane extends StackPane implements AutoCloseable {
    static final double HEIGHT = 64;
    private static final PseudoClass STALE = PseudoClass.getPseudoClass("stale");
    private static final PseudoClass MISSING = PseudoClass.getPseudoClass("missing");
    private static final PseudoClass FAILED = PseudoClass.getPseudoClass("failed");
    private static final PseudoClass CURRENT = PseudoClass.getPseudoClass("here");
    private static final double MEGABYTE = 1e6;
    /** Width of the status message while no machine is connected, pixels. */
    private static final double MESSAGE_WIDTH = 420;

    private final EditorModel model;
    private final SceneEditor editor;
    private final TimelineModel timeline;
    private final Pane slots = new Pane();
    private final Label cost = new Label();
    private final Label progress = new Label();
    private final Button localButton = new Button(Messages.tr("Render Locally"));
    /** Status, below the track names and left of the thumbnails. */
    private final VBox statusBox = new VBox();
    private final HBox question;
    private final Button startButton = new Button(Messages.tr("Cache Frames"));
    private final Button remoteButton = new Button(Messages.tr("Render on Other Machines…"));
    private final List<Slot> visibleSlots = new ArrayList<>();
    private final Subscription subscription;
    private final RemoteFramePreview remotePreview;
    private @Nullable MachinesWindow machinesWindow;
    private @Nullable FilmStrip strip;
    /** Scene whose thumbnail was measured last, or is being measured; null before the first. */
    private @Nullable Scene measuredScene;
    /** Bytes of one frame; 0 while unknown. */
    private long frameBytes;

    /** Thumbnail at its position. */
    private static final class Slot extends StackPane {
        private final ImageView image = new ImageView();
        private final Label number = new Label();
        private int frame = -1;
        private int @Nullable [] pixels;

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

    FilmStripPane(EditorModel model, TimelineModel timeline) {
        this.model = model;
        editor = model.editor();
        this.timeline = timeline;
        remotePreview = new RemoteFramePreview(editor, model.files().windowExecutor(), this::showRemoteFilm);
        setId("strip");
        getStyleClass().add("film-strip");
        setMinHeight(HEIGHT + 4);
        setMaxHeight(HEIGHT + 4);
        cost.setId("strip-cost");
        cost.getStyleClass().add("pane-note");
        cost.setWrapText(true);
        startButton.setId("strip-begin");
        startButton.setMinWidth(USE_PREF_SIZE);
        startButton.setOnAction(_ -> useLocalFrames());
        remoteButton.setId("strip-elsewhere");
        remoteButton.setMinWidth(USE_PREF_SIZE);
        remoteButton.setOnAction(_ -> askMachines());
        question = new HBox(cost, startButton, remoteButton);
        question.getStyleClass().add("no-shot");
        progress.setId("strip-progress");
        progress.getStyleClass().add("strip-progress");
        progress.setMouseTransparent(true);
        localButton.setId("strip-here");
        localButton.getStyleClass().addAll("small", "strip-here");
        localButton.setOnAction(_ -> useLocalFrames());
        progress.setWrapText(true);
        statusBox.getChildren().addAll(progress, localButton);
        statusBox.getStyleClass().add("strip-told");
        statusBox.setPickOnBounds(false);
        statusBox.setMaxSize(TrackCell.NAME_WIDTH, USE_PREF_SIZE);
        setAlignment(statusBox, Pos.TOP_LEFT);
        getChildren().addAll(slots, statusBox, question);
        slots.setOnMouseClicked(e -> {
            if (e.getButton() == MouseButton.PRIMARY) {
                visibleSlots.stream().filter(s -> s.getBoundsInParent().contains(e.getX(), e.getY())).findFirst()
                        .ifPresent(s -> editor.showFrame(s.frame));
            }
        });
        subscription = Subscription.combine(timeline.scaleProperty().subscribe(_ -> draw()),
                editor.editorStateProperty().subscribe(this::update),
                model.picture().outputViewProperty().subscribe(v -> {
                    if (strip != null) {
                        strip.setView(v);
                    }
                }));
    }

    private void useLocalFrames() {
        closeStrip();
        EditorState state = editor.editorStateProperty().get();
        state.shotFrame().ifPresent(m -> {
            var status = new FilmStripStatus();
            openStrip(LocalFrames.of(m.shot(), editor.document().content().base(), status), status);
        });
        update(state);
    }

    private void openStrip(FilmStripFrames frames, FilmStripStatus status) {
        strip = new FilmStrip(frames, status, model.picture().outputView(), model.files().windowExecutor(),
                this::stripChanged,
                editor.message()::show);
    }

    /** Returns the film strip; empty if no frames are cached. */
    Optional<FilmStrip> strip() {
        return Optional.ofNullable(strip);
    }

    private Path folder() {
        return model.fileImporter().folder();
    }

    /**
     * Shows a remote film in the main picture until the local render is ready. Does nothing if another scene is being rendered or only a
     * region is shown.
     */
    private void showRemoteFilm(Film film, Scene scene) {
        if (editor.editorStateProperty().get().sceneInProgress().filter(s -> s == scene).isPresent()
                && model.pictureDisplay().isFullPicture()) {
            model.picture().showRemote(film, scene);
        }
    }

    private void askMachines() {
        if (machinesWindow != null) {
            machinesWindow.toFront();
            return;
        }
        Window owner = getScene().getWindow();
        machinesWindow = new MachinesWindow(
                new MachinesPane(editor, model.files(), model.renderMachines(), PathPrompt.ofSystem(owner, folder())), owner,
                model.commands(),
                this::useRemoteFrames);
        machinesWindow.addEventHandler(WindowEvent.WINDOW_HIDDEN, _ -> machinesWindow = null);
        machinesWindow.show();
    }

    private void useRemoteFrames(RemoteFrames frames) {
        closeStrip();
        openStrip(frames, frames.status());
        update(editor.editorStateProperty().get());
    }

    /** Drops all frames and stops observing. */
    @Override
    public void close() {
        subscription.unsubscribe();
        if (machinesWindow != null) {
            machinesWindow.close();
        }
        closeStrip();
    }

    private void closeStrip() {
        if (strip != null) {
            strip.close();
            strip = null;
        }
        draw();
    }

    private void update(EditorState state) {
        Optional<Shot> shot = state.shotFrame().map(m -> m.shot());
        if (strip != null && (shot.filter(strip::matches).isEmpty() || !isSameFolder())) {
            // Other frames need a different amount of memory, which the user must confirm again.
            closeStrip();
        }
        if (strip != null) {
            strip.frames().setPictureBusy(state.sceneInProgress().isPresent() || state.verifying());
            strip.show(editor.document().content(), state.shotFrame().orElseThrow().frame());
            remotePreview.update(state, strip);
        }
        if (strip == null) {
            shot.ifPresent(this::showCost);
        }
        question.setVisible(strip == null);
        draw();
    }

    private boolean isSameFolder() {
        return !(currentStrip().frames() instanceof RemoteFrames remote) || remote.folder().equals(folder());
    }

    private void stripChanged() {
        if (strip != null) {
            remotePreview.update(editor.editorStateProperty().get(), strip);
        }
        draw();
    }

    /** Shows the memory of the frames, as soon as that of one is measured. */
    private void showCost(Shot shot) {
        Scene base = editor.document().content().base();
        if (measuredScene == null || !needsSameMemory(base, measuredScene)) {
            measuredScene = base;
            frameBytes = 0;
            model.files().runConcurrently(() -> LocalFrames.measureBytes(base), bytes -> showCost(base, bytes),
                    _ -> showCost(base, LocalFrames.budget() + 1));
        }
        long frames = (long) shot.last() - shot.first() + 1;
        String text = Messages.tr("Caches {0} thumbnails and relights them after each edit", frames);
        // Other frames of the shot need a little more or less, and frames that do not fit are traced again.
        boolean fits = frameBytes <= LocalFrames.budget();
        cost.setText(frameBytes == 0 ? text + "."
                : fits ? text + " " + Messages.tr("(about {0} MB).", Math.max(1, Math.round(frames * frameBytes / MEGABYTE)))
                : text + ". " + Messages.tr("Not enough memory."));
        startButton.setDisable(!fits);
    }

    /** Returns whether the frames of two scenes need about the same memory. */
    private static boolean needsSameMemory(Scene a, Scene b) {
        return a.picture().equals(b.picture()) && a.stage() == b.stage()
                && a.rig().effectiveLights().size() == b.rig().effectiveLights().size();
    }

    private void showCost(Scene measured, long bytes) {
        if (measured == measuredScene) {
            frameBytes = bytes;
            if (strip == null) {
                editor.editorStateProperty().get().shotFrame().ifPresent(frame -> showCost(frame.shot()));
            }
        }
    }

    private void draw() {
        if (strip == null || timeline.shotProperty().get() == null || !strip.matches(timeline.shotProperty().get())) {
            slots.getChildren().clear();
            visibleSlots.clear();
            showStatus("", false);
            return;
        }
        Shot shot = timeline.shotProperty().get();
        FrameScale scale = timeline.scaleProperty().get();
        PictureSettings picture = FilmStrip.thumbnailScene(editor.document().content().base()).picture();
        double width = Math.max(8, HEIGHT * picture.width() / picture.height()) + 2;
        List<SlotPosition> positions = slotPositions(shot, scale, width);
        while (visibleSlots.size() < positions.size()) {
            var slot = new Slot();
            visibleSlots.add(slot);
            slots.getChildren().add(slot);
        }
        while (visibleSlots.size() > positions.size()) {
            slots.getChildren().remove(visibleSlots.removeLast());
        }
        int currentFrame = nearest(positions, editor.document().shotFrame().map(m -> m.frame()).orElse(-1));
        strip.setVisibleFrames(nearestFirst(positions, currentFrame));
        for (int i = 0; i < positions.size(); i++) {
            show(visibleSlots.get(i), positions.get(i), width, currentFrame);
        }
        showStatus(FilmStripText.status(strip, shot), strip.frames().machineCount().isPresent());
    }

    private void showStatus(String text, boolean isRemote) {
        progress.setText(text);
        progress.setVisible(!text.isEmpty());
        // Without machines there are no new thumbnails, so the message may cover them.
        statusBox.setMaxWidth(
                isRemote && currentStrip().frames().machineCount().orElseThrow() == 0 ? MESSAGE_WIDTH : TrackCell.NAME_WIDTH);
        localButton.setVisible(isRemote);
        localButton.setManaged(isRemote);
    }

    /**
     * Frame and the position of its thumbnail.
     *
     * @param x left edge, pixels from the end of the track names
     */
    private record SlotPosition(int frame, double x) {}

    private static int nearest(List<SlotPosition> positions, int currentFrame) {
        return nearestFirst(positions, currentFrame).stream().findFirst().orElse(-1);
    }

    private static List<Integer> nearestFirst(List<SlotPosition> positions, int currentFrame) {
        return positions.stream().map(SlotPosition::frame)
                .sorted((a, b) -> Integer.compare(Math.abs(a - currentFrame), Math.abs(b - currentFrame))).toList();
    }

    /** Returns the thumbnails that fit without overlap, each centered at its frame, from the first visible frame. */
    private static List<SlotPosition> slotPositions(Shot shot, FrameScale scale, double width) {
        List<SlotPosition> positions = new ArrayList<>();
        double freeX = 0;
        int frame = Math.max(shot.first(), scale.frame(0));
        while (frame <= shot.last() && scale.isVisible(frame)) {
            double x = Math.max(0, Math.min(scale.x(frame) - width / 2, scale.width() - width));
            if (x >= freeX) {
                positions.add(new SlotPosition(frame, x));
                freeX = x + width;
            }
            frame = Math.max(frame + 1, scale.frame(freeX + width / 2));
        }
        return positions;
    }

    private void show(Slot slot, SlotPosition position, double width, int currentFrame) {
        int frame = position.frame();
        slot.frame = frame;
        slot.setId("strip-" + frame);
        slot.number.setText(String.valueOf(frame));
        FrameState state = currentStrip().state(frame);
        slot.pseudoClassStateChanged(STALE, state != FrameState.FAILED && !currentStrip().isUpToDate(frame));
        slot.pseudoClassStateChanged(MISSING, state == FrameState.MISSING);
        slot.pseudoClassStateChanged(FAILED, state == FrameState.FAILED);
        slot.pseudoClassStateChanged(CURRENT, frame == currentFrame);
        FilmStrip.Thumbnail thumbnail = currentStrip().thumbnail(frame).orElse(null);
        int[] pixels = thumbnail == null ? null : thumbnail.pixels();
        if (pixels != slot.pixels) {
            slot.pixels = pixels;
            slot.image.setImage(thumbnail == null ? null : PixelImage.of(thumbnail.film().width(), thumbnail.film().height(), pixels));
        }
        slot.setAccessibleText(FilmStripText.frameText(currentStrip(), frame));
        slot.resizeRelocate(TrackCell.NAME_WIDTH + position.x(), 2, width - 2, HEIGHT);
    }

    /** Returns the strip, which exists while slots or machines are shown. */
    private FilmStrip currentStrip() {
        return requireNonNull(strip);
    }
}
