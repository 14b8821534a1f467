package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.ValueWidget;
import lightning.scene.Stage;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.ShapeLinks;

/** Menu for a light-linking attribute: check boxes of shapes and groups, and whether the list includes or excludes them. */
final class LinksField extends StackPane implements ValueWidget<ShapeLinks> {
    /** Approximate limit of listed shapes and groups. Further ones can be linked in the scene file. */
    private static final int MAX_NODES = 200;
    private static final double INDENT = 16;

    private final SceneEditor editor;
    private final Consumer<UnaryOperator<ShapeLinks>> onEdited;
    private final CommandMenuItems commandItems;
    private final MenuButton choice = new MenuButton();
    private final DisabledReason disabledReason;
    private ShapeLinks shown = ShapeLinks.ALL;

    /**
     * @param title  for screen readers
     * @param help  tooltip text
     * @param onEdited  receives changes of the links
     */
    LinksField(EditorModel model, String id, String title, String help, Consumer<UnaryOperator<ShapeLinks>> onEdited) {
        editor = model.editor();
        this.onEdited = onEdited;
        commandItems = CommandMenuItems.forMenu(model.commands());
        choice.setId(id);
        choice.setAccessibleText(title);
        choice.setMaxWidth(Double.MAX_VALUE);
        choice.setMnemonicParsing(false);
        // An empty menu never opens.
        choice.getItems().setAll(new SeparatorMenuItem());
        choice.setOnShowing(_ -> fillMenu());
        getChildren().add(choice);
        disabledReason = new DisabledReason(this, choice, help);
    }

    @Override
    public void show(ShapeLinks links) {
        shown = links;
        choice.setText(Messages.tr(links.format()));
    }

    @Override
    public void showNothing() {
        show(ShapeLinks.ALL);
    }

    @Override
    public void setDisabledReason(Optional<String> reason) {
        disabledReason.set(reason);
    }

    private void fillMenu() {
        List<MenuItem> items = new ArrayList<>(List.of(modeItem(Messages.tr("Exclude Selected"), false, shown),
                modeItem(Messages.tr("Include Only Selected"), true, shown), new SeparatorMenuItem()));
        addItems(shown, items);
        choice.getItems().setAll(items);
    }

    private MenuItem modeItem(String title, boolean only, ShapeLinks links) {
        return commandItems.radioValue(Command.LINK, title, links.exclusive() == only,
                () -> onEdited.accept(l -> new ShapeLinks(only, l.names())));
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
                    checked -> onEdited.accept(l -> l.with(node.name(), checked))));
            shapes += switch (node) {
                case NodeGroup g when expanded.contains(g.name()) -> addItems(g.children(), depth + 1, links, expanded, items);
                case NodeGroup _ -> 0;
                case Shape _ -> 1;
            };
        }
        return shapes;
    }
}
