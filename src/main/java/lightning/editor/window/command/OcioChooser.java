package lightning.editor.window.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.beans.binding.BooleanBinding;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;
import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.document.FileThread;
import lightning.editor.window.model.ErrorMessage;
import lightning.format.ocio.OcioConfig;
import lightning.format.ocio.OcioReference;
import org.jspecify.annotations.Nullable;

/** Fields for a configuration of OpenColorIO, one of its displays and a view of it. */
final class OcioChooser extends GridPane {
    private static final double GAP = 8;
    private static final double WIDTH = 420;

    private final FileThread files;
    private final OcioReference proposal;
    private final TextField source = new TextField();
    private final ComboBox<String> display = new ComboBox<>();
    private final ComboBox<String> view = new ComboBox<>();
    private final CheckBox keeps = new CheckBox(Messages.tr("Keep the LUT next to the scene"));
    private final Label status = new Label();
    private @Nullable OcioConfig config;

    /**
     * Creates the fields and reads the proposed configuration.
     *
     * @param proposal configuration and view that are chosen first; the configuration may be empty
     * @param browse   opens a file dialog
     * @param canKeep  true if the scene has a file
     */
    OcioChooser(FileThread files, OcioReference proposal, Supplier<Optional<Path>> browse, boolean canKeep) {
        this.files = files;
        this.proposal = proposal;
        setHgap(GAP);
        setVgap(GAP);
        source.setId("ocio-config");
        source.setText(proposal.config());
        source.setPromptText("config.ocio, ocio://default");
        source.setAccessibleText(Messages.tr("Configuration"));
        source.setPrefWidth(WIDTH);
        source.setOnAction(event -> {
            read();
            // Enter reads the configuration; it does not close the dialog.
            event.consume();
        });
        source.focusedProperty().addListener((_, _, isFocused) -> {
            if (!isFocused) {
                read();
            }
        });
        var button = new Button(Messages.tr("Browse…"));
        button.setId("ocio-browse");
        button.setOnAction(_ -> browse.get().ifPresent(file -> {
            source.setText(file.toString());
            read();
        }));
        display.setId("ocio-display");
        display.setAccessibleText(Messages.tr("Display"));
        display.valueProperty().addListener((_, _, _) -> showViews());
        view.setId("ocio-view");
        view.setAccessibleText(Messages.tr("View"));
        keeps.setId("ocio-keep");
        keeps.setDisable(!canKeep);
        keeps.setSelected(canKeep);
        status.setId("ocio-status");
        status.setWrapText(true);
        addRow(0, new Label(Messages.tr("Configuration")), source, button);
        addRow(1, new Label(Messages.tr("Display")), display);
        addRow(2, new Label(Messages.tr("View")), view);
        add(keeps, 1, 3);
        add(status, 0, 4, 3, 1);
        for (ComboBox<String> box : List.of(display, view)) {
            box.setMaxWidth(Double.MAX_VALUE);
            setHgrow(box, Priority.ALWAYS);
        }
        read();
    }

    /** Reads the configuration in the background, unless its views are shown. */
    private void read() {
        String name = source.getText().strip();
        if (name.isEmpty() || config != null && config.source().equals(name)) {
            return;
        }
        config = null;
        display.getItems().clear();
        status.setText(Messages.tr("Reading {0}…", name));
        files.runConcurrently(() -> OcioConfig.read(name, Progress.NONE), read -> {
            if (name.equals(source.getText().strip())) {
                show(read);
            }
        }, failure -> {
            if (name.equals(source.getText().strip())) {
                status.setText(ErrorMessage.of(failure));
            }
        });
    }

    private void show(OcioConfig read) {
        config = read;
        status.setText("");
        display.getItems().setAll(read.displays().stream().map(OcioConfig.Display::name).toList());
        OcioConfig.Choice first = first(read);
        display.getSelectionModel().select(first.display());
        view.getSelectionModel().select(first.view());
    }

    /** Returns the proposed view if the configuration has it, else its default. */
    private OcioConfig.Choice first(OcioConfig read) {
        try {
            return read.find(proposal.view());
        } catch (IOException e) {
            return new OcioConfig.Choice(0,
                    Math.max(0, read.displays().getFirst().views().indexOf(read.displays().getFirst().defaultView())));
        }
    }

    private void showViews() {
        int chosen = display.getSelectionModel().getSelectedIndex();
        if (config == null || chosen < 0) {
            view.getItems().clear();
            return;
        }
        OcioConfig.Display of = config.displays().get(chosen);
        view.getItems().setAll(of.views());
        view.getSelectionModel().select(Math.max(0, of.views().indexOf(of.defaultView())));
    }

    /** Returns a binding that is true while no view is chosen. */
    BooleanBinding isIncomplete() {
        return view.getSelectionModel().selectedItemProperty().isNull();
    }

    /** Returns the configuration whose views are shown. */
    Optional<OcioConfig> config() {
        return Optional.ofNullable(config);
    }

    /** Returns the chosen view. */
    OcioConfig.Choice choice() {
        return new OcioConfig.Choice(display.getSelectionModel().getSelectedIndex(), view.getSelectionModel().getSelectedIndex());
    }

    /** Returns whether the table is written next to the scene. */
    boolean keepsTable() {
        return keeps.isSelected();
    }
}
