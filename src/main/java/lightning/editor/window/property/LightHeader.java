package lightning.editor.window.property;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.SceneSelection;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.LightTypes;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.kordamp.ikonli.javafx.FontIcon;

/** Header with the selected light's name, type and switches, and its commands. */
final class LightHeader extends VBox {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private final SceneEditor editor;
    private final SceneSelection selection;
    private final CommandRegistry commands;
    private final TextField name = new TextField();
    private final Label refusal = new Label();
    private final ComboBox<LightType> type = new ComboBox<>();
    private final ToggleButton onToggle = new ToggleButton();
    private final ToggleButton solo = new ToggleButton();
    private String shownName = "";
    private boolean isUpdating;

    LightHeader(SceneEditor editor, CommandRegistry commands) {
        this.editor = editor;
        this.commands = commands;
        selection = editor.selection();
        getStyleClass().add("light-header");
        buildName();
        buildType();
        StackPane onBox = toggle(onToggle, "light-on", Messages.tr("On"), Messages.tr("Switch the light on or off"), Command.SWITCH_ON);
        StackPane soloBox =
                toggle(solo, "light-solo", Messages.tr("Solo"), Messages.tr("Mute all lights that are not solo"), Command.SOLO);
        HBox identity = row(withDisabledReason(name, Command.RENAME_LIGHT, Messages.tr("Light name")),
                withDisabledReason(type, Command.CHANGE_TYPE, Messages.tr("Light type (keeps all settings)")));
        HBox.setHgrow(identity.getChildren().getFirst(), Priority.ALWAYS);
        Region gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        HBox buttons = row(onBox, soloBox, gap,
                CommandButton.iconButton(commands, Command.UNDO_LIGHT),
                CommandButton.iconButton(commands, Command.REDO_LIGHT),
                CommandButton.iconButton(commands, Command.COPY_SETTINGS),
                CommandButton.iconButton(commands, Command.PASTE_SETTINGS),
                CommandButton.iconButton(commands, Command.LOOK_THROUGH_LIGHT));
        getChildren().addAll(identity, refusal, buttons);
        commands.setAction(Command.CHANGE_TYPE, type::show);
        editor.editorStateProperty().subscribe(this::show);
    }

    private void buildName() {
        name.setId("light-name");
        name.setPromptText(Messages.tr("no light"));
        name.setAccessibleText(Messages.tr("name"));
        name.setOnAction(_ -> rename());
        name.focusedProperty().addListener((_, wasFocused, _) -> {
            if (wasFocused) {
                rename();
            }
        });
        name.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE && !name.getText().equals(selection.lightName())) {
                revert();
                event.consume();
            }
        });
        refusal.getStyleClass().add("refusal");
        refusal.setWrapText(true);
        refusal.managedProperty().bind(refusal.visibleProperty());
        refusal.visibleProperty().bind(refusal.textProperty().isNotEmpty());
    }

    private void buildType() {
        type.setId("light-type");
        type.setAccessibleText(Messages.tr("type"));
        type.getItems().setAll(LightType.values());
        type.setConverter(LightTypes.CONVERTER);
        type.valueProperty().addListener((_, _, now) -> {
            if (!isUpdating && now != null && selection.light() != null) {
                editor.editOrReport(scene -> LightEdits.setType(scene, selection.lightName(), now));
            }
        });
    }

    private StackPane toggle(ToggleButton button, String id, String text, String hint, Command command) {
        button.setText(text);
        button.setId(id);
        button.getStyleClass().add("small");
        button.setMinWidth(Region.USE_PREF_SIZE);
        button.setOnAction(_ -> {
            commands.run(command);
            show(editor.editorStateProperty().get());
        });
        if (command == Command.SWITCH_ON) {
            FontIcon icon = new FontIcon();
            icon.iconCodeProperty().bind(button.selectedProperty().map(LightTypes::onIcon));
            button.setGraphic(icon);
        }
        return withDisabledReason(button, command, hint);
    }

    private StackPane withDisabledReason(Region control, Command command, String hint) {
        control.setMaxWidth(Double.MAX_VALUE);
        StackPane wrapper = new StackPane(control);
        var reason = new DisabledReason(wrapper, control, hint);
        editor.editorStateProperty().subscribe(_ -> reason.set(commands.disabledReason(command)));
        return wrapper;
    }

    private static HBox row(Region... parts) {
        HBox row = new HBox(parts);
        row.getStyleClass().add("header-row");
        return row;
    }

    private void show(EditorState state) {
        Optional<Light> light = state.selectedLight();
        isUpdating = true;
        type.setValue(light.map(Light::type).orElse(null));
        isUpdating = false;
        onToggle.setSelected(light.map(Light::on).orElse(false));
        onToggle.setText(light.map(Light::on).orElse(true) ? Messages.tr("On") : Messages.tr("Off"));
        solo.setSelected(light.map(Light::solo).orElse(false));
        if (!shownName.equals(selection.lightName())) {
            revert();
        }
    }

    /** Discards uncommitted input. */
    void revert() {
        shownName = selection.lightName();
        name.setText(shownName);
        showRefusal("");
    }

    private void rename() {
        String typed = name.getText().strip();
        if (selection.light() == null || typed.equals(selection.lightName())) {
            revert();
        } else {
            String old = selection.lightName();
            editor.edit(scene -> LightEdits.rename(scene, old, typed)).ifPresentOrElse(this::showRefusal, this::revert);
        }
    }

    private void showRefusal(String reason) {
        refusal.setText(reason);
        name.setAccessibleHelp(reason);
        name.pseudoClassStateChanged(REFUSED, !reason.isEmpty());
    }
}
