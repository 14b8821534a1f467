package lightning.editor.window.property;

import java.util.List;
import javafx.collections.FXCollections;
import javafx.collections.ObservableSet;
import javafx.collections.SetChangeListener;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Texts;
import lightning.editor.document.BankEdits;
import lightning.editor.document.Command;
import lightning.editor.document.LightEdits;
import lightning.editor.document.Situation;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.LightTypes;
import lightning.editor.window.widget.Obstacle;
import lightning.scene.LightType;
import lightning.scene.Rig;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignP;

/**
 * The lights of the scene. The keyboard: F2 renames, Delete deletes, Ctrl+D duplicates, Space switches on and off, S
 * makes solo.
 */
public final class LightListPane extends VBox {
    private final SceneEditor editor;
    private final Commands commands;
    private final ListView<RigRow> list = new ListView<>();
    private final ObservableSet<String> folded = FXCollections.observableSet();
    /** The bank whose line is selected; empty while that of the selected light is. */
    private String bankInHand = "";
    private boolean showing;

    public LightListPane(SceneEditor editor, Commands commands) {
        this.editor = editor;
        this.commands = commands;
        setId("lights");
        getStyleClass().add("lights");
        list.setId("light-list");
        list.getStyleClass().addAll("light-list", "edge-to-edge");
        list.setAccessibleText(Texts.of("lights"));
        list.setPlaceholder(new Label(Texts.of("No lights. Add one above.")));
        list.setCellFactory(_ -> new LightCell(editor, commands, folded));
        folded.addListener((SetChangeListener<String>) _ -> show(editor.situationProperty().get()));
        list.setContextMenu(menu());
        list.addEventHandler(KeyEvent.KEY_PRESSED, this::press);
        list.getSelectionModel().selectedIndexProperty().addListener((_, _, now) -> select(now.intValue()));
        setVgrow(list, Priority.ALWAYS);
        getChildren().addAll(tools(), list);
        commands.setAction(Command.RENAME_LIGHT, this::rename);
        editor.situationProperty().subscribe(this::show);
    }

    private HBox tools() {
        MenuButton add = new MenuButton(Texts.of("Add Light"), new FontIcon(MaterialDesignP.PLUS));
        add.setId("add-light");
        CommandItems items = CommandItems.of(commands);
        for (LightType type : List.of(LightType.POINT, LightType.SPOT, LightType.DIRECTIONAL, LightType.RECT, LightType.DISC)) {
            MenuItem item = items.value(Command.ADD_LIGHT, LightTypes.title(type), () -> add(type));
            item.setGraphic(new FontIcon(LightTypes.icon(type)));
            add.getItems().add(item);
        }
        StackPane around = new StackPane(add);
        var obstacle = new Obstacle(around, add, Texts.of("Add a light at the camera's upper right"));
        editor.situationProperty().subscribe(_ -> obstacle.set(commands.reason(Command.ADD_LIGHT)));
        Region gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        HBox tools = new HBox(around, gap,
                CommandButton.icon(commands, Command.DUPLICATE_LIGHT),
                CommandButton.icon(commands, Command.DELETE_LIGHT));
        tools.getStyleClass().add("lights-tools");
        return tools;
    }

    private void add(LightType type) {
        if (editor.editOrReport(scene -> LightEdits.add(scene, type)).isEmpty()) {
            editor.selection().selectLight(editor.scene().lights().getLast().name());
        }
    }

    private ContextMenu menu() {
        CommandItems items = CommandItems.of(commands, "of-light-");
        return new ContextMenu(items.item(Command.RENAME_LIGHT), items.item(Command.DUPLICATE_LIGHT), items.item(Command.DELETE_LIGHT),
                new SeparatorMenuItem(), items.item(Command.NEW_BANK), items.item(Command.DELETE_BANK),
                new SeparatorMenuItem(), items.item(Command.COPY_SETTINGS), items.item(Command.PASTE_SETTINGS), new SeparatorMenuItem(),
                items.item(Command.SWITCH_ON), items.item(Command.SOLO), items.item(Command.LOOK_THROUGH_LIGHT));
    }

    private void press(KeyEvent event) {
        if (!bankInHand.isEmpty() && pressOnBank(event.getCode())) {
            event.consume();
            return;
        }
        Command command = switch (event.getCode()) {
            case DELETE, BACK_SPACE -> Command.DELETE_LIGHT;
            case SPACE -> Command.SWITCH_ON;
            case F2 -> Command.RENAME_LIGHT;
            case S -> event.isShortcutDown() ? null : Command.SOLO;
            case D -> event.isShortcutDown() ? Command.DUPLICATE_LIGHT : null;
            default -> null;
        };
        if (command != null && list.getEditingIndex() < 0) {
            commands.run(command);
            event.consume();
        }
    }

    /** The keys of lights do for a bank what they do for a light. */
    private boolean pressOnBank(KeyCode key) {
        String bank = bankInHand;
        switch (key) {
            case DELETE, BACK_SPACE -> editor.editOrReport(scene -> BankEdits.delete(scene, bank));
            case SPACE -> editor.editOrReport(scene -> BankEdits.with(scene, bank, b -> b.withOn(!b.on())));
            case S -> editor.editOrReport(scene -> BankEdits.with(scene, bank, b -> b.withSolo(!b.solo())));
            case F2 -> list.lookupAll(".list-cell").stream().map(LightCell.class::cast)
                    .filter(c -> c.getItem() instanceof RigRow.OfBank && c.bank().equals(bank)).forEach(LightCell::renameBank);
            default -> {
                return false;
            }
        }
        return true;
    }

    /** Only until the cell ends it is the list editable, or a second click on a light would rename it. */
    private void rename() {
        list.setEditable(true);
        list.edit(list.getSelectionModel().getSelectedIndex());
    }

    private void select(int index) {
        if (!showing && index >= 0) {
            bankInHand = "";
            switch (list.getItems().get(index)) {
                case RigRow.OfLight(int place) -> editor.selection().selectLight(editor.scene().lights().get(place).name());
                case RigRow.OfBank(int place) -> bankInHand = editor.scene().rig().banks().get(place).name();
            }
        }
    }

    /** The list knows places alone, and cells what stands there: an edit of a light touches its cell, and the list not at all. */
    private void show(Situation now) {
        showing = true;
        Rig rig = now.scene().rig();
        List<RigRow> rows = RigRow.of(rig, folded);
        RigRow inHand = list.getSelectionModel().getSelectedItem();
        boolean same = list.getItems().equals(rows);
        if (!same) {
            list.getItems().setAll(rows);
        }
        if (rig.bank(bankInHand).isEmpty()) {
            // A bank of another name in the same place is the same bank, renamed.
            bankInHand = same && inHand instanceof RigRow.OfBank(int place) ? rig.banks().get(place).name() : "";
        }
        RigRow wanted = !bankInHand.isEmpty() ? new RigRow.OfBank(rig.banks().indexOf(rig.bank(bankInHand).orElseThrow()))
                : now.selected().<RigRow>map(l -> new RigRow.OfLight(rig.lights().indexOf(l))).orElse(null);
        int selected = rows.indexOf(wanted);
        if (selected < 0) {
            list.getSelectionModel().clearSelection();
        } else if (list.getSelectionModel().getSelectedIndex() != selected) {
            list.getSelectionModel().clearAndSelect(selected);
            list.scrollTo(selected);
        }
        showing = false;
    }
}
