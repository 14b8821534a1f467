package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.EditorState;
import lightning.editor.document.LightEdits;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisabledReason;
import lightning.scene.Stage;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.ShapeLinks;

/** Menu for a light-linking attribute: check boxes of shapes and groups, and whether the list includes or excludes them. */
final class LinksField extends StackPane {
    /** Approximate limit of listed shapes and groups. Further ones can be linked in the scene file. */
    private static final int MAX_NODES = 200;
    private static final double INDENT = 16;

    private final SceneEditor editor;
    private final LightAttribute<ShapeLinks> attribute;
    private final CommandMenuItems commandItems;
    private final MenuButton choice = new MenuButton();
    private final DisabledReason disabledReason;

    /** @param visibleState  state as in {@link PropertyPane} */
    LinksField(SceneEditor editor, CommandRegistry commands, LightAttribute<ShapeLinks> attribute, ValueKind.LinksKind kind,
            ObservableValue<EditorState> visibleState) {
        this.editor = editor;
        this.attribute = attribute;
        commandItems = CommandMenuItems.forMenu(commands);
        choice.setId(attribute.name());
        choice.setAccessibleText(Messages.tr(attribute.title()));
        choice.setMaxWidth(Double.MAX_VALUE);
        choice.setMnemonicParsing(false);
        // An empty menu never opens.
        choice.getItems().setAll(new SeparatorMenuItem());
        choice.setOnShowing(_ -> fillMenu());
        getChildren().add(choice);
        disabledReason = new DisabledReason(this, choice, Messages.tr(kind.help()));
        visibleState.subscribe(this::show);
    }

    private void show(EditorState state) {
        choice.setText(state.selectedLight().map(attribute::format).map(Messages::tr).orElse(Messages.tr("all")));
        disabledReason.set(Command.LINK.disabledReason(state));
    }

    private void fillMenu() {
        Light light = editor.selection().light();
        List<MenuItem> items = new ArrayList<>();
        if (light != null) {
            ShapeLinks links = attribute.get(light);
            items.add(modeItem(Messages.tr("Exclude Selected"), false, links));
            items.add(modeItem(Messages.tr("Include Only Selected"), true, links));
            items.add(new SeparatorMenuItem());
            addItems(links, items);
        }
        choice.getItems().setAll(items);
    }

    private MenuItem modeItem(String title, boolean only, ShapeLinks links) {
        return commandItems.radioValue(Command.LINK, title, links.exclusive() == only, () -> set(l -> new ShapeLinks(only, l.names())));
    }

    /** Adds the top-level nodes, then the contents of groups that fit completely. */
    private void addItems(ShapeLinks links, List<MenuItem> items) {
        Stage stage = editor.scene().stage();
        Set<String> expanded = new HashSet<>();
        int remaining = MAX_NODES - stage.nodes().size();
        List<NodeGroup> groups =
                new ArrayList<>(links.names().stream().flatMap(name -> stage.enclosingGroups(name).stream()).distinct().toList());
        groups(stage.nodes()).forEach(groups::add);
        for (int i = 0; i < groups.size() && remaining > 0; i++) {
            NodeGroup group = groups.get(i);
            if (group.children().size() <= remaining && expanded.add(group.name())) {
                remaining -= group.children().size();
                groups(group.children()).forEach(groups::add);
            }
        }
        int shapeCount = addItems(stage.nodes(), 0, links, expanded, items);
        if (shapeCount < stage.shapeCount()) {
            items.add(CommandMenuItems.placeholder(Command.LINK, Messages.tr("Link further objects in the scene file")));
        }
    }

    private static Stream<NodeGroup> groups(List<SceneNode> nodes) {
        return nodes.stream().limit(MAX_NODES).filter(NodeGroup.class::isInstance).map(NodeGroup.class::cast);
    }

    /** @return number of listed shapes */
    private int addItems(List<SceneNode> nodes, int depth, ShapeLinks links, Set<String> expanded, List<MenuItem> items) {
        int shapes = 0;
        for (SceneNode node : nodes.subList(0, Math.min(nodes.size(), MAX_NODES))) {
            items.add(commandItems.checkBoxValue(Command.LINK, node.name(), links.names().contains(node.name()), INDENT * depth,
                    checked -> set(l -> l.with(node.name(), checked))));
            shapes += switch (node) {
                case NodeGroup g when expanded.contains(g.name()) -> addItems(g.children(), depth + 1, links, expanded, items);
                case NodeGroup _ -> 0;
                case Shape _ -> 1;
            };
        }
        return shapes;
    }

    private void set(UnaryOperator<ShapeLinks> edit) {
        String name = editor.selection().lightName();
        editor.editOrReport(scene -> LightEdits.edit(scene, name, light -> attribute.with(light, edit.apply(attribute.get(light)))));
    }
}
