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
import lightning.base.text.Messages;
import lightning.document.LightEdits;
import lightning.document.LightGroupEdits;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.LightTypes;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignP;

/** List of the scene's lights. Keys: F2 renames, Delete deletes, Ctrl+D duplicates, Space switches on or off, S toggles solo. */
public final class LightListPane extends VBox {
    private final SceneEditor editor;
    private final CommandRegistry commands;
    private final ListView<LightListRow> list = new ListView<>();
    private final ObservableSet<String> collapsedGroups = FXCollections.observableSet();
    /** Selected light group; empty while a light is selected. */
    private String selectedGroup = "";
    private boolean isUpdating;

    public LightListPane(SceneEditor editor, CommandRegistry commands) {
        this.editor = editor;
        this.commands = commands;
        setId("lights");
        getStyleClass().add("lights");
        list.setId("light-list");
        list.getStyleClass().addAll("light-list", "edge-to-edge");
        list.setAccessibleText(Messages.tr("lights"));
        list.setPlaceholder(new Label(Messages.tr("No lights. Add one above.")));
        list.setCellFactory(_ -> new LightCell(editor, commands, collapsedGroups));
        collapsedGroups.addListener((SetChangeListener<String>) _ -> show(editor.editorStateProperty().get()));
        list.setContextMenu(menu());
        list.addEventHandler(KeyEvent.KEY_PRESSED, this::handleKey);
        list.getSelectionModel().selectedIndexProperty().addListener((_, _, now) -> select(now.intValue()));
        setVgrow(list, Priority.ALWAYS);
        getChildren().addAll(tools(), list);
        commands.setAction(Command.RENAME_LIGHT, this::rename);
        editor.editorStateProperty().subscribe(this::show);
    }

    private HBox tools() {
        MenuButton add = new MenuButton(Messages.tr("Add Light"), new FontIcon(MaterialDesignP.PLUS));
        add.setId("add-light");
        CommandMenuItems items = CommandMenuItems.forMenu(commands);
        for (LightType type : List.of(LightType.POINT, LightType.SPOT, LightType.DIRECTIONAL, LightType.RECT, LightType.DISC,
                LightType.TUBE)) {
            MenuItem item = items.value(Command.ADD_LIGHT, LightTypes.title(type), () -> add(type));
            item.setGraphic(new FontIcon(LightTypes.icon(type)));
            add.getItems().add(item);
        }
        StackPane wrapper = new StackPane(add);
        var reason = new DisabledReason(wrapper, add, Messages.tr("Add a light at the camera's upper right"));
        editor.editorStateProperty().subscribe(_ -> reason.set(commands.disabledReason(Command.ADD_LIGHT)));
        Region gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        HBox tools = new HBox(wrapper, gap,
                CommandButton.iconButton(commands, Command.DUPLICATE_LIGHT),
                CommandButton.iconButton(commands, Command.DELETE_LIGHT));
        tools.getStyleClass().add("lights-tools");
        return tools;
    }

    private void add(LightType type) {
        if (editor.editOrReport(scene -> LightEdits.add(scene, type)).isEmpty()) {
            editor.selection().selectLight(editor.scene().lights().getLast().name());
        }
    }

    private ContextMenu menu() {
        CommandMenuItems items = CommandMenuItems.forMenu(commands, "of-light-");
        return new ContextMenu(items.item(Command.RENAME_LIGHT), items.item(Command.DUPLICATE_LIGHT), items.item(Command.DELETE_LIGHT),
                new SeparatorMenuItem(), items.item(Command.NEW_LIGHT_GROUP), items.item(Command.DELETE_LIGHT_GROUP),
                new SeparatorMenuItem(), items.item(Command.COPY_SETTINGS), items.item(Command.PASTE_SETTINGS), new SeparatorMenuItem(),
                items.item(Command.SWITCH_ON), items.item(Command.SOLO), items.item(Command.LOOK_THROUGH_LIGHT));
    }

    private void handleKey(KeyEvent event) {
        if (!selectedGroup.isEmpty() && handleGroupKey(event.getCode())) {
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

    /** Applies the shortcuts of lights to a light group. */
    private boolean handleGroupKey(KeyCode key) {
        String group = selectedGroup;
        switch (key) {
            case DELETE, BACK_SPACE -> editor.editOrReport(scene -> LightGroupEdits.delete(scene, group));
            case SPACE -> editor.editOrReport(scene -> LightGroupEdits.edit(scene, group, b -> b.withOn(!b.on())));
            case S -> editor.editOrReport(scene -> LightGroupEdits.edit(scene, group, b -> b.withSolo(!b.solo())));
            case F2 -> list.lookupAll(".list-cell").stream().map(LightCell.class::cast)
                    .filter(c -> c.getItem() instanceof LightListRow.GroupRow && c.groupName().equals(group))
                    .forEach(LightCell::renameGroup);
            default -> {
                return false;
            }
        }
        return true;
    }

    /** Renames the selected light. The list is editable only meanwhile, since a second click would otherwise rename. */
    private void rename() {
        list.setEditable(true);
        list.edit(list.getSelectionModel().getSelectedIndex());
    }

    private void select(int index) {
        if (!isUpdating && index >= 0) {
            selectedGroup = "";
            switch (list.getItems().get(index)) {
                case LightListRow.LightRow(int place) -> editor.selection().selectLight(editor.scene().lights().get(place).name());
                case LightListRow.GroupRow(int place) -> selectedGroup = editor.scene().rig().lightGroups().get(place).name();
            }
        }
    }

    /** Updates the rows. Rows store indices and cells look up the content, so that editing a light redraws its cell only. */
    private void show(EditorState state) {
        isUpdating = true;
        LightRig rig = state.scene().rig();
        List<LightListRow> rows = LightListRow.of(rig, collapsedGroups);
        LightListRow selectedRow = list.getSelectionModel().getSelectedItem();
        boolean isUnchanged = list.getItems().equals(rows);
        if (!isUnchanged) {
            list.getItems().setAll(rows);
        }
        if (rig.lightGroup(selectedGroup).isEmpty()) {
            // Another name at the same index means that the group was renamed.
            selectedGroup =
                    isUnchanged && selectedRow instanceof LightListRow.GroupRow(int place) ? rig.lightGroups().get(place).name() : "";
        }
        LightListRow targetRow =
                !selectedGroup.isEmpty() ? new LightListRow.GroupRow(rig.lightGroups().indexOf(rig.lightGroup(selectedGroup).orElseThrow()))
                        : state.selectedLight().<LightListRow>map(l -> new LightListRow.LightRow(rig.lights().indexOf(l))).orElse(null);
        int selected = rows.indexOf(targetRow);
        if (selected < 0) {
            list.getSelectionModel().clearSelection();
        } else if (list.getSelectionModel().getSelectedIndex() != selected) {
            list.getSelectionModel().clearAndSelect(selected);
            list.scrollTo(selected);
        }
        isUpdating = false;
    }
}
