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
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.LightEdits;
import lightning.editor.document.Situation;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.SceneSelection;
import lightning.editor.window.widget.LightTypes;
import lightning.editor.window.widget.Obstacle;
import lightning.scene.Light;
import lightning.scene.LightType;
import org.kordamp.ikonli.javafx.FontIcon;

/** The selected light's name, type and switches, and the commands that concern it alone. */
final class LightHeader extends VBox {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private final SceneEditor editor;
    private final SceneSelection selection;
    private final Commands commands;
    private final TextField name = new TextField();
    private final Label refusal = new Label();
    private final ComboBox<LightType> type = new ComboBox<>();
    private final ToggleButton on = new ToggleButton();
    private final ToggleButton solo = new ToggleButton();
    private String shownName = "";
    private boolean showing;

    LightHeader(SceneEditor editor, Commands commands) {
        this.editor = editor;
        this.commands = commands;
        selection = editor.selection();
        getStyleClass().add("light-header");
        buildName();
        buildType();
        StackPane onBox = toggle(on, "light-on", Texts.of("On"), Texts.of("Whether the light shines"), Command.SWITCH_ON);
        StackPane soloBox = toggle(solo, "light-solo", Texts.of("Solo"), Texts.of("Show only the lights that are solo"), Command.SOLO);
        HBox identity = row(surrounded(name, Command.RENAME_LIGHT, Texts.of("The light's name")),
                surrounded(type, Command.CHANGE_TYPE, Texts.of("The light's type; all settings are kept")));
        HBox.setHgrow(identity.getChildren().getFirst(), Priority.ALWAYS);
        Region gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        HBox buttons = row(onBox, soloBox, gap,
                CommandButton.icon(commands, Command.UNDO_LIGHT),
                CommandButton.icon(commands, Command.REDO_LIGHT),
                CommandButton.icon(commands, Command.COPY_SETTINGS),
                CommandButton.icon(commands, Command.PASTE_SETTINGS),
                CommandButton.icon(commands, Command.LOOK_THROUGH_LIGHT));
        getChildren().addAll(identity, refusal, buttons);
        commands.setAction(Command.CHANGE_TYPE, type::show);
        editor.situationProperty().subscribe(this::show);
    }

    private void buildName() {
        name.setId("light-name");
        name.setPromptText(Texts.of("no light"));
        name.setAccessibleText(Texts.of("name"));
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
        type.setAccessibleText(Texts.of("type"));
        type.getItems().setAll(LightType.values());
        type.setConverter(LightTypes.CONVERTER);
        type.valueProperty().addListener((_, _, now) -> {
            if (!showing && now != null && selection.light() != null) {
                editor.editOrReport(scene -> LightEdits.type(scene, selection.lightName(), now));
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
            show(editor.situationProperty().get());
        });
        if (command == Command.SWITCH_ON) {
            FontIcon icon = new FontIcon();
            icon.iconCodeProperty().bind(button.selectedProperty().map(LightTypes::bulb));
            button.setGraphic(icon);
        }
        return surrounded(button, command, hint);
    }

    private StackPane surrounded(Region control, Command command, String hint) {
        control.setMaxWidth(Double.MAX_VALUE);
        StackPane around = new StackPane(control);
        var obstacle = new Obstacle(around, control, hint);
        editor.situationProperty().subscribe(_ -> obstacle.set(commands.reason(command)));
        return around;
    }

    private static HBox row(Region... parts) {
        HBox row = new HBox(parts);
        row.getStyleClass().add("header-row");
        return row;
    }

    private void show(Situation now) {
        Optional<Light> light = now.selected();
        showing = true;
        type.setValue(light.map(Light::type).orElse(null));
        showing = false;
        on.setSelected(light.map(Light::on).orElse(false));
        solo.setSelected(light.map(Light::solo).orElse(false));
        if (!shownName.equals(selection.lightName())) {
            revert();
        }
    }

    /** Forgets what was typed. */
    void revert() {
        shownName = selection.lightName();
        name.setText(shownName);
        mark("");
    }

    private void rename() {
        String typed = name.getText().strip();
        if (selection.light() == null || typed.equals(selection.lightName())) {
            revert();
        } else {
            String old = selection.lightName();
            editor.edit(scene -> LightEdits.rename(scene, old, typed)).ifPresentOrElse(this::mark, this::revert);
        }
    }

    private void mark(String reason) {
        refusal.setText(reason);
        name.setAccessibleHelp(reason);
        name.pseudoClassStateChanged(REFUSED, !reason.isEmpty());
    }
}
