package lightning.editor.window.timeline;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Texts;
import lightning.base.work.OwnThread;
import lightning.editor.document.FileThread;
import lightning.editor.window.command.PathAsk;
import lightning.editor.window.model.MachineChoice;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.Sentence;
import lightning.scene.shot.Shot;
import lightning.shot.cluster.HostPort;

/** Where the other machines are, and the file that lets this one take part. */
final class MachinesPane extends VBox {
    private final SceneEditor editor;
    private final FileThread files;
    private final MachineChoice choice;
    private final TextField hosts = new TextField();
    private final TextField certificate = new TextField();
    private final Button begin = new Button(Texts.of("Keep the Frames There"));
    private final Label status = new Label();
    private Consumer<FramesElsewhere> joined = _ -> {};
    /** Of what was begun last: whoever is of another time comes too late. */
    private int attempt;

    MachinesPane(SceneEditor editor, FileThread files, MachineChoice choice, PathAsk ask) {
        this.editor = editor;
        this.files = files;
        this.choice = choice;
        setId("machines");
        getStyleClass().add("shot-export");
        var about = new Label(Texts.of("Nodes on these machines hold the frames at their full size. The scene and its files go to them, "
                + "encrypted; who has the certificate takes part, and nobody else."));
        about.getStyleClass().add("pane-note");
        about.setWrapText(true);
        about.setMinHeight(USE_PREF_SIZE);
        hosts.setId("machines-hosts");
        hosts.setText(choice.hostsProperty().get());
        hosts.setPromptText(Texts.of("render7:7800, render8"));
        hosts.setAccessibleText(Texts.of("machines"));
        certificate.setId("machines-certificate");
        certificate.setText(choice.certificateProperty().get());
        certificate.setAccessibleText(Texts.of("certificate"));
        var browse = new Button(Texts.of("Browse…"));
        browse.setId("machines-browse");
        browse.setMinWidth(USE_PREF_SIZE);
        browse.setOnAction(_ -> ask.fileToOpen(Texts.of("Certificate of the Machines"), "p12")
                .ifPresent(file -> certificate.setText(file.toString())));
        begin.setId("machines-begin");
        begin.getStyleClass().add("accent");
        begin.setOnAction(_ -> begin());
        hosts.setOnAction(_ -> begin());
        certificate.setOnAction(_ -> begin());
        status.setId("machines-status");
        status.setWrapText(true);
        status.setMinHeight(USE_PREF_SIZE);
        var fields = new GridPane(8, 8);
        fields.addRow(0, label(Texts.of("Machines")), hosts);
        fields.addRow(1, label(Texts.of("Certificate")), certificate, browse);
        GridPane.setHgrow(hosts, Priority.ALWAYS);
        GridPane.setHgrow(certificate, Priority.ALWAYS);
        GridPane.setColumnSpan(hosts, 2);
        getChildren().addAll(about, fields, begin, status);
    }

    private static Label label(String text) {
        var label = new Label(text);
        label.setMinWidth(USE_PREF_SIZE);
        return label;
    }

    /** @param then gets the frames on these machines, on the window's thread; they are its own from then on */
    void whenJoined(Consumer<FramesElsewhere> then) {
        joined = then;
    }

    private void begin() {
        if (begin.isDisabled() || editor.document().moment().isEmpty()) {
            return;
        }
        String asked = hosts.getText().strip();
        List<HostPort> machines;
        try {
            machines = HostPort.several(asked);
        } catch (IllegalArgumentException e) {
            status.setText(e.getMessage());
            hosts.requestFocus();
            return;
        }
        if (certificate.getText().isBlank()) {
            status.setText(Texts.of("Name the certificate that all machines have; “lightning node --make-certificate FILE” makes one"));
            certificate.requestFocus();
            return;
        }
        choice.hostsProperty().set(asked);
        choice.certificateProperty().set(certificate.getText().strip());
        Shot shot = editor.document().moment().orElseThrow().shot();
        Path folder = editor.document().file().toAbsolutePath().getParent();
        String file = choice.certificateProperty().get();
        begin.setDisable(true);
        status.setText(Texts.of("Asking for the machines…"));
        int mine = ++attempt;
        files.beside(() -> FramesElsewhere.join(asked, machines, Path.of(file), folder, shot), frames -> {
            if (mine == attempt) {
                begin.setDisable(false);
                joined.accept(frames);
            } else {
                OwnThread.of("lightning-strip-close", frames::close).start();
            }
        }, why -> {
            if (mine == attempt) {
                begin.setDisable(false);
                status.setText(why instanceof IllegalArgumentException ? why.getMessage() : Sentence.of(why));
            }
        });
    }

    /** Nobody waits any more for what was begun. */
    void stop() {
        attempt++;
    }
}
