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
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.base.work.DedicatedThread;
import lightning.document.FileThread;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.RenderMachines;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.shot.Shot;
import lightning.shot.cluster.HostPort;

/** Addresses of the render nodes, and the certificate file for joining them. */
final class MachinesPane extends VBox {
    private final SceneEditor editor;
    private final FileThread files;
    private final RenderMachines choice;
    private final TextField hosts = new TextField();
    private final TextField certificate = new TextField();
    private final Button joinButton = new Button(Messages.tr("Render on These Machines"));
    private final Label status = new Label();
    private Consumer<RemoteFrames> onJoined = _ -> {};
    /** Number of the latest attempt; results of earlier ones are discarded. */
    private int attempt;

    MachinesPane(SceneEditor editor, FileThread files, RenderMachines choice, PathPrompt pathPrompt) {
        this.editor = editor;
        this.files = files;
        this.choice = choice;
        setId("machines");
        getStyleClass().add("shot-export");
        var about = new Label(Messages.tr("Render nodes on these machines cache the frames at full size. "
                + "The scene and its files are sent encrypted. Only nodes with this certificate can join."));
        about.getStyleClass().add("pane-note");
        about.setWrapText(true);
        about.setMinHeight(USE_PREF_SIZE);
        hosts.setId("machines-hosts");
        hosts.setText(choice.hostsProperty().get());
        hosts.setPromptText(Messages.tr("render7:7800, render8"));
        hosts.setAccessibleText(Messages.tr("machines"));
        certificate.setId("machines-certificate");
        certificate.setText(choice.certificateProperty().get());
        certificate.setAccessibleText(Messages.tr("certificate"));
        var browse = new Button(Messages.tr("Browse…"));
        browse.setId("machines-browse");
        browse.setMinWidth(USE_PREF_SIZE);
        browse.setOnAction(_ -> pathPrompt.fileToOpen(Messages.tr("Certificate of the Render Nodes"), "p12")
                .ifPresent(file -> certificate.setText(file.toString())));
        joinButton.setId("machines-begin");
        joinButton.getStyleClass().add("accent");
        joinButton.setOnAction(_ -> join());
        hosts.setOnAction(_ -> join());
        certificate.setOnAction(_ -> join());
        status.setId("machines-status");
        status.setWrapText(true);
        status.setMinHeight(USE_PREF_SIZE);
        var fields = new GridPane(8, 8);
        fields.addRow(0, label(Messages.tr("Machines")), hosts);
        fields.addRow(1, label(Messages.tr("Certificate")), certificate, browse);
        GridPane.setHgrow(hosts, Priority.ALWAYS);
        GridPane.setHgrow(certificate, Priority.ALWAYS);
        GridPane.setColumnSpan(hosts, 2);
        getChildren().addAll(about, fields, joinButton, status);
    }

    private static Label label(String text) {
        var label = new Label(text);
        label.setMinWidth(USE_PREF_SIZE);
        return label;
    }

    /**
     * Sets the listener for a successful connection.
     *
     * @param listener receives the remote frames on the window's thread and must close them
     */
    void setOnJoined(Consumer<RemoteFrames> listener) {
        onJoined = listener;
    }

    private void join() {
        if (joinButton.isDisabled() || editor.document().shotFrame().isEmpty()) {
            return;
        }
        String hostsText = hosts.getText().strip();
        List<HostPort> machines;
        try {
            machines = HostPort.parseAll(hostsText);
        } catch (RefusalException e) {
            status.setText(e.getMessage());
            hosts.requestFocus();
            return;
        }
        if (certificate.getText().isBlank()) {
            status.setText(Messages
                    .tr("Choose the render nodes' shared certificate. Create one with “lightning node --make-certificate FILE”."));
            certificate.requestFocus();
            return;
        }
        choice.hostsProperty().set(hostsText);
        choice.certificateProperty().set(certificate.getText().strip());
        Shot shot = editor.document().shotFrame().orElseThrow().shot();
        Path folder = ParentFolder.of(editor.document().file());
        String file = choice.certificateProperty().get();
        joinButton.setDisable(true);
        status.setText(Messages.tr("Connecting…"));
        int thisAttempt = ++attempt;
        files.runConcurrently(() -> RemoteFrames.join(hostsText, machines, Path.of(file), folder, shot), frames -> {
            if (thisAttempt == attempt) {
                joinButton.setDisable(false);
                onJoined.accept(frames);
            } else {
                DedicatedThread.create("lightning-strip-close", frames::close).start();
            }
        }, failure -> {
            if (thisAttempt == attempt) {
                joinButton.setDisable(false);
                status.setText(failure instanceof IllegalArgumentException ? failure.getMessage() : ErrorMessage.of(failure));
            }
        });
    }

    /** Discards the result of a running attempt. */
    void cancel() {
        attempt++;
    }
}
