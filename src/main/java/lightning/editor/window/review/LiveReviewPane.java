package lightning.editor.window.review;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.TimeUnit;
import javafx.animation.Animation;
import javafx.animation.KeyFrame;
import javafx.animation.Timeline;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.image.ImageView;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.util.Duration;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.document.loop.Frame;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.VisibilityListener;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.review.Review;
import lightning.review.live.LiveAddress;
import lightning.review.live.LiveChange;
import lightning.review.live.LiveReview;
import lightning.shot.cluster.ClusterCertificate;
import lightning.shot.cluster.JoinException;
import org.jspecify.annotations.Nullable;

/**
 * Starts and ends a live review, and lists its notes. The review ends with the window of the panel. Changes of reviewers are edits that undo
 * takes back; changes that follow each other within a second are one step.
 */
public final class LiveReviewPane extends VBox {
    private static final long GESTURE_NANOS = TimeUnit.SECONDS.toNanos(1);
    private static final Duration COUNT_INTERVAL = Duration.seconds(1);

    private final EditorModel model;
    private final SceneEditor editor;
    private final Button run = new Button();
    private final CheckBox allowsEdits = new CheckBox(Messages.tr("Reviewers May Change Lights"));
    private final TextField address = new TextField();
    private final TextField certificate = new TextField();
    private final TextField url = new TextField();
    private final Button copy = new Button(Messages.tr("Copy"));
    private final Button open = new Button(Messages.tr("Open in Browser"));
    private final ImageView code = new ImageView();
    private final Label state = new Label();
    private final ListView<String> notes = new ListView<>();
    private final SequencedMap<String, LiveChange> newest = new LinkedHashMap<>();
    private final Timeline counter = new Timeline(new KeyFrame(COUNT_INTERVAL, _ -> showState()));
    private @Nullable LiveReview review;
    private @Nullable PixelCache shown;
    private @Nullable ViewTransform shownView;
    private Object gesture = new Object();
    private long lastChange;
    /** Page whose change is being applied; empty for an edit of the artist. */
    private String page = "";
    private String problem = "";

    public LiveReviewPane(EditorModel model) {
        this.model = model;
        editor = model.editor();
        setId("live-review");
        getStyleClass().add("contributions");
        run.setId("live-run");
        run.getStyleClass().add("accent");
        run.setMinWidth(Region.USE_PREF_SIZE);
        run.setOnAction(_ -> {
            if (review == null) {
                start();
            } else {
                end();
            }
        });
        allowsEdits.setId("live-edits");
        allowsEdits.setTooltip(new Tooltip(Messages.tr("Faders of a page move the lights of this scene; undo takes it back")));
        var head = row(run, allowsEdits);
        address.setId("live-address");
        address.setPromptText(Messages.tr("This computer only"));
        address.setAccessibleText(Messages.tr("Address for other computers"));
        address.setTooltip(
                new Tooltip(Messages.tr("Address of this computer for others, such as 192.168.1.5 or 192.168.1.5:8443; empty for none")));
        address.setPrefColumnCount(14);
        certificate.setId("live-certificate");
        certificate.setPromptText(Messages.tr("Certificate"));
        certificate.setAccessibleText(Messages.tr("File of the certificate"));
        certificate.setText(model.renderMachines().certificateProperty().get());
        certificate.setTooltip(new Tooltip(
                Messages.tr("File that encrypts what other computers receive; create one with 'lightning node --make-certificate'")));
        HBox.setHgrow(certificate, Priority.ALWAYS);
        var where = row(new Label(Messages.tr("Address:")), address, certificate);
        url.setId("live-url");
        url.setEditable(false);
        url.setAccessibleText(Messages.tr("Address of the page"));
        HBox.setHgrow(url, Priority.ALWAYS);
        copy.setId("live-copy");
        copy.setMinWidth(Region.USE_PREF_SIZE);
        copy.setOnAction(_ -> {
            var content = new ClipboardContent();
            content.putString(url.getText());
            Clipboard.getSystemClipboard().setContent(content);
            state.setText(Messages.tr("Copied; send it to the reviewers"));
        });
        open.setId("live-open");
        open.setMinWidth(Region.USE_PREF_SIZE);
        open.setOnAction(_ -> model.browse(url.getText()));
        code.setId("live-code");
        code.setAccessibleText(Messages.tr("QR code of the address"));
        code.setPreserveRatio(true);
        code.setSmooth(false);
        code.managedProperty().bind(code.imageProperty().isNotNull());
        code.visibleProperty().bind(code.managedProperty());
        var codeBox = new HBox(code);
        codeBox.setAlignment(Pos.CENTER);
        codeBox.setMinHeight(Region.USE_PREF_SIZE);
        state.setId("live-state");
        state.getStyleClass().add("pane-note");
        state.setWrapText(true);
        state.setMinHeight(Region.USE_PREF_SIZE);
        state.setMaxWidth(Double.MAX_VALUE);
        notes.setId("live-notes");
        notes.setAccessibleText(Messages.tr("Notes of reviewers"));
        notes.setPlaceholder(new Label(Messages.tr("Notes of reviewers appear here")));
        VBox.setVgrow(notes, Priority.ALWAYS);
        getChildren().addAll(head, where, row(url, copy, open), row(state), codeBox, notes);
        counter.setCycleCount(Animation.INDEFINITE);
        show();
        VisibilityListener.attach(this, this::subscribe);
    }

    private static HBox row(Region... nodes) {
        var row = new HBox(nodes);
        row.getStyleClass().add("mixer-tools");
        return row;
    }

    /** Starts to observe scene and picture; the review ends with the window. */
    private Subscription subscribe() {
        counter.play();
        return Subscription.combine(editor.sceneProperty().subscribe(scene -> {
            if (review != null && scene != null) {
                review.show(scene, page);
            }
        }), model.picture().renderStateProperty().subscribe(_ -> showPicture()),
                model.picture().viewProperty().subscribe(_ -> showPicture()), counter::stop, this::end);
    }

    private void start() {
        Optional<LiveAddress> at = chosenAddress();
        if (at.isEmpty()) {
            showState();
            return;
        }
        String title = editor.document().name();
        boolean edits = allowsEdits.isSelected();
        run.setDisable(true);
        model.files().runConcurrently(() -> LiveReview.start(title, at.get(), edits,
                change -> model.files().windowExecutor().execute(() -> receive(change))), started -> {
                    problem = "";
                    review = started;
                    newest.clear();
                    notes.getItems().clear();
                    shown = null;
                    started.show(editor.scene(), "");
                    showPicture();
                    show();
                }, failure -> {
                    problem = ErrorMessage.of(failure);
                    show();
                });
    }

    private Optional<LiveAddress> chosenAddress() {
        String text = address.getText().strip();
        if (text.isEmpty()) {
            return Optional.of(LiveAddress.LOCAL);
        }
        String file = certificate.getText().strip();
        try {
            return Optional.of(LiveAddress.parse(text,
                    file.isEmpty() ? Optional.empty() : Optional.of(ClusterCertificate.sslContext(Path.of(file)))));
        } catch (IOException | JoinException | InvalidPathException e) {
            problem = ErrorMessage.of(e);
            return Optional.empty();
        }
    }

    private void end() {
        LiveReview ended = review;
        review = null;
        if (ended != null) {
            // Closing waits until pages know of it.
            model.files().runConcurrently(() -> {
                ended.close();
                return "";
            }, _ -> {}, _ -> {});
        }
        show();
    }

    private void show() {
        run.setDisable(false);
        run.setText(review == null ? Messages.tr("Start Review") : Messages.tr("End Review"));
        for (Region setting : List.of(allowsEdits, address, certificate)) {
            setting.setDisable(review != null);
        }
        url.setText(review == null ? "" : review.url());
        copy.setDisable(review == null);
        open.setDisable(review == null);
        // Telephones reach this computer by an address for others only.
        code.setImage(review == null || address.getText().isBlank() ? null : QrImage.of(review.url()));
        showState();
    }

    private void showState() {
        if (review == null) {
            state.setText(problem.isEmpty() ? Messages.tr("Reviewers see the picture with a fader for each light, in their browser")
                    : problem);
            return;
        }
        int pages = review.pages();
        state.setText(!review.problem().isEmpty() ? review.problem() : pages == 0 ? Messages.tr("No page is open")
                : pages == 1 ? Messages.tr("One page is open")
                : Messages.tr("{0} pages are open", pages));
    }

    private void showPicture() {
        Frame frame = model.picture().frame();
        PixelCache cache = model.workbench().cache().orElse(null);
        if (review == null || frame == null || !frame.isFinished() || cache == null) {
            return;
        }
        ViewTransform view = model.picture().outputView();
        if (cache != shown || !view.equals(shownView)) {
            shown = cache;
            shownView = view;
            review.show(cache, RenderOptions.DEFAULT, view);
        }
    }

    /** Applies the change of a page as an edit. */
    private void receive(LiveChange change) {
        if (review == null) {
            return;
        }
        change.storeNotes(newest);
        showNotes();
        boolean hasValues =
                !change.state().lights().isEmpty() || !change.state().groups().isEmpty() || change.state().exposure().isPresent();
        if (!hasValues) {
            return;
        }
        long now = System.nanoTime();
        if (now - lastChange > GESTURE_NANOS) {
            gesture = new Object();
        }
        lastChange = now;
        String reviewer = change.reviewer().isBlank() ? Messages.tr("a reviewer") : change.reviewer();
        page = change.page();
        try {
            editor.editAndRenderOrReport(
                    scene -> EditOutcome.of(() -> change.state().applyTo(scene)).named(Messages.tr("Review of {0}", reviewer)),
                    gesture);
        } finally {
            page = "";
        }
    }

    private void showNotes() {
        List<String> lines = new ArrayList<>();
        for (LiveChange change : newest.values()) {
            for (Review.Note note : change.notes()) {
                String place = Messages.tr("{0}, {1}: {2}", Math.round(note.x() * editor.scene().picture().width()),
                        Math.round(note.y() * editor.scene().picture().height()), note.text());
                lines.add(change.reviewer().isBlank() ? place : change.reviewer() + " – " + place);
            }
        }
        if (!lines.equals(notes.getItems())) {
            notes.getItems().setAll(lines);
        }
    }
}
