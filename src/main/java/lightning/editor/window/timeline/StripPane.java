package lightning.editor.window.timeline;

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
import lightning.base.text.Texts;
import lightning.base.work.Memory;
import lightning.editor.document.Situation;
import lightning.editor.window.command.PathAsk;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.PixelImage;
import lightning.render.image.Film;
import lightning.scene.Picture;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.shot.FrameState;

/** The film strip below the keys: frames as small pictures, as many as have room; a click goes to the frame. Nothing is kept before it is asked. */
final class StripPane extends StackPane implements AutoCloseable {
    static final double HEIGHT = 64;
    private static final PseudoClass STALE = PseudoClass.getPseudoClass("stale");
    private static final PseudoClass MISSING = PseudoClass.getPseudoClass("missing");
    private static final PseudoClass FAILED = PseudoClass.getPseudoClass("failed");
    private static final PseudoClass HERE = PseudoClass.getPseudoClass("here");
    private static final double MEGABYTE = 1e6;
    /** The width of what is told while no machine is there, pixels. */
    private static final double ALONE = 420;

    private final EditorModel model;
    private final SceneEditor editor;
    private final Timeline timeline;
    private final Pane slots = new Pane();
    private final Label cost = new Label();
    private final Label progress = new Label();
    private final Button here = new Button(Texts.of("Keep Here Again"));
    /** Below the names, beside the pictures. */
    private final VBox told = new VBox();
    private final HBox question;
    private final Button begin = new Button(Texts.of("Keep the Frames"));
    private final Button elsewhere = new Button(Texts.of("On Other Machines…"));
    private final List<Slot> shown = new ArrayList<>();
    private final Subscription following;
    private final FilmAhead ahead;
    private MachinesWindow asking;
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
        editor = model.editor();
        this.timeline = timeline;
        ahead = new FilmAhead(editor, model.files().window(), this::showAhead);
        setId("strip");
        getStyleClass().add("film-strip");
        setMinHeight(HEIGHT + 4);
        setMaxHeight(HEIGHT + 4);
        cost.setId("strip-cost");
        cost.getStyleClass().add("pane-note");
        cost.setWrapText(true);
        begin.setId("strip-begin");
        begin.setMinWidth(USE_PREF_SIZE);
        begin.setOnAction(_ -> keepHere());
        elsewhere.setId("strip-elsewhere");
        elsewhere.setMinWidth(USE_PREF_SIZE);
        elsewhere.setOnAction(_ -> askMachines());
        question = new HBox(cost, begin, elsewhere);
        question.getStyleClass().add("no-shot");
        progress.setId("strip-progress");
        progress.getStyleClass().add("strip-progress");
        progress.setMouseTransparent(true);
        here.setId("strip-here");
        here.getStyleClass().addAll("small", "strip-here");
        here.setOnAction(_ -> keepHere());
        progress.setWrapText(true);
        told.getChildren().addAll(progress, here);
        told.getStyleClass().add("strip-told");
        told.setPickOnBounds(false);
        told.setMaxSize(TrackCell.NAME, USE_PREF_SIZE);
        setAlignment(told, Pos.TOP_LEFT);
        getChildren().addAll(slots, told, question);
        slots.setOnMouseClicked(e -> {
            if (e.getButton() == MouseButton.PRIMARY && !editor.isAnimating()) {
                shown.stream().filter(s -> s.getBoundsInParent().contains(e.getX(), e.getY())).findFirst()
                        .ifPresent(s -> editor.showFrame(s.frame));
            }
        });
        following = Subscription.combine(timeline.scaleProperty().subscribe(_ -> draw()),
                editor.situationProperty().subscribe(this::follow),
                model.picture().viewProperty().subscribe(v -> {
                    if (strip != null) {
                        strip.setView(v.ofPicture());
                    }
                }));
    }

    private void keepHere() {
        end();
        Situation now = editor.situationProperty().get();
        now.moment().filter(m -> fits(m.shot())).ifPresent(m -> {
            var news = new StripNews();
            begin(FramesHere.of(m.shot(), editor.document().content().still(), news), news);
        });
        follow(now);
    }

    private void begin(StripFrames frames, StripNews news) {
        strip = new FilmStrip(frames, news, model.picture().viewProperty().get().ofPicture(), model.files().window(), this::heard,
                editor.message()::show);
    }

    /** Empty where no frames are kept. */
    Optional<FilmStrip> strip() {
        return Optional.ofNullable(strip);
    }

    private Path folder() {
        return model.bringer().folder();
    }

    /** Shows a film in the large picture until that is rendered here, unless something else is rendered or only a part is shown. */
    private void showAhead(Film film, Scene of) {
        if (editor.situationProperty().get().inWork().filter(s -> s == of).isPresent() && model.look().isPlain()) {
            model.picture().showAhead(film, of);
        }
    }

    private void askMachines() {
        if (asking != null) {
            asking.toFront();
            return;
        }
        Window owner = getScene().getWindow();
        asking = new MachinesWindow(
                new MachinesPane(editor, model.files(), model.machineChoice(), PathAsk.inWindows(owner, folder())), owner, model.commands(),
                this::keepElsewhere);
        asking.addEventHandler(WindowEvent.WINDOW_HIDDEN, _ -> asking = null);
        asking.show();
    }

    private void keepElsewhere(FramesElsewhere frames) {
        end();
        begin(frames, frames.news());
        follow(editor.situationProperty().get());
    }

    /** Lets go of all frames, and hears no more. */
    @Override
    public void close() {
        following.unsubscribe();
        if (asking != null) {
            asking.close();
        }
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
        if (strip != null && (shot.filter(strip::isOf).isEmpty() || !isOfThisFolder())) {
            // Other frames take other room: that is asked anew.
            end();
        }
        if (strip != null && !editor.isAnimating()) {
            strip.frames().setUrgent(now.inWork().isPresent() || now.verifying());
            strip.show(editor.document().content(), now.moment().orElseThrow().frame());
            ahead.follow(now, strip);
        }
        if (strip == null) {
            shot.ifPresent(this::ask);
        }
        question.setVisible(strip == null);
        draw();
    }

    private boolean isOfThisFolder() {
        return !(strip.frames() instanceof FramesElsewhere far) || far.folder().equals(folder());
    }

    private void heard() {
        if (strip != null && !editor.isAnimating()) {
            ahead.follow(editor.situationProperty().get(), strip);
        }
        draw();
    }

    private boolean fits(Shot shot) {
        return FramesHere.bytes(editor.document().content().still(), shot) <= Memory.available() / 2;
    }

    private void ask(Shot shot) {
        long bytes = FramesHere.bytes(editor.document().content().still(), shot);
        cost.setText(Texts.of("The strip keeps {0} small frames and relights them after each edit: at most {1} MB of memory.",
                (long) shot.last() - shot.first() + 1, Math.max(1, Math.round(bytes / MEGABYTE)))
                + (fits(shot) ? "" : " " + Texts.of("That is more than there is for it.")));
        begin.setDisable(!fits(shot));
    }

    private void draw() {
        if (strip == null || timeline.shotProperty().get() == null || !strip.isOf(timeline.shotProperty().get())) {
            slots.getChildren().clear();
            shown.clear();
            tell("", false);
            return;
        }
        Shot shot = timeline.shotProperty().get();
        FrameScale scale = timeline.scaleProperty().get();
        Picture picture = FilmStrip.small(editor.document().content().still()).picture();
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
        int now = nearest(places, editor.document().moment().map(m -> m.frame()).orElse(-1));
        strip.see(nearestFirst(places, now));
        for (int i = 0; i < places.size(); i++) {
            show(shown.get(i), places.get(i), width, now);
        }
        tell(StripWords.of(strip, shot), strip.frames().machines().isPresent());
    }

    private void tell(String words, boolean far) {
        progress.setText(words);
        progress.setVisible(!words.isEmpty());
        // Where nobody makes any, what is told may lie over the pictures.
        told.setMaxWidth(far && strip.frames().machines().orElseThrow() == 0 ? ALONE : TrackCell.NAME);
        here.setVisible(far);
        here.setManaged(far);
    }

    /**
     * A frame and where its picture begins.
     *
     * @param x pixels behind the names
     */
    private record Place(int frame, double x) {}

    private static int nearest(List<Place> places, int here) {
        return nearestFirst(places, here).stream().findFirst().orElse(-1);
    }

    private static List<Integer> nearestFirst(List<Place> places, int here) {
        return places.stream().map(Place::frame).sorted((a, b) -> Integer.compare(Math.abs(a - here), Math.abs(b - here))).toList();
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
        slot.pseudoClassStateChanged(STALE, state != FrameState.FAILED && !strip.showsNewest(frame));
        slot.pseudoClassStateChanged(MISSING, state == FrameState.MISSING);
        slot.pseudoClassStateChanged(FAILED, state == FrameState.FAILED);
        slot.pseudoClassStateChanged(HERE, frame == here);
        FilmStrip.Small small = strip.picture(frame).orElse(null);
        int[] pixels = small == null ? null : small.pixels();
        if (pixels != slot.pixels) {
            slot.pixels = pixels;
            slot.image.setImage(small == null ? null : PixelImage.of(small.film().width(), small.film().height(), pixels));
        }
        slot.setAccessibleText(StripWords.ofFrame(strip, frame));
        slot.resizeRelocate(TrackCell.NAME + place.x(), 2, width - 2, HEIGHT);
    }
}
