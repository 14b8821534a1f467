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
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.LightEdits;
import lightning.editor.document.Situation;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.Obstacle;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Links;
import lightning.scene.Node;
import lightning.scene.Shape;
import lightning.scene.Stage;
import lightning.scene.ValueKind;

/** Some links of the selected light: which shapes and groups, by check marks in a menu, and whether only those or all but those. */
final class LinksPart extends StackPane {
    /** About so many shapes and groups are offered; links that name others can be written in the file. */
    private static final int MOST = 200;
    private static final double INDENT = 16;

    private final SceneEditor editor;
    private final LightAttribute<Links> attribute;
    private final CommandItems make;
    private final MenuButton choice = new MenuButton();
    private final Obstacle obstacle;

    /** @param seen as in {@link PropertyPane} */
    LinksPart(SceneEditor editor, Commands commands, LightAttribute<Links> attribute, ValueKind.Linking kind,
            ObservableValue<Situation> seen) {
        this.editor = editor;
        this.attribute = attribute;
        make = CommandItems.of(commands);
        choice.setId(attribute.name());
        choice.setAccessibleText(Texts.of(attribute.title()));
        choice.setMaxWidth(Double.MAX_VALUE);
        choice.setMnemonicParsing(false);
        // A menu that has no item never opens.
        choice.getItems().setAll(new SeparatorMenuItem());
        choice.setOnShowing(_ -> fill());
        getChildren().add(choice);
        obstacle = new Obstacle(this, choice, Texts.of(kind.help()));
        seen.subscribe(this::show);
    }

    private void show(Situation now) {
        choice.setText(now.selected().map(attribute::text).map(Texts::of).orElse(Texts.of("all")));
        obstacle.set(Command.LINK.obstacle(now));
    }

    private void fill() {
        Light light = editor.selection().light();
        List<MenuItem> items = new ArrayList<>();
        if (light != null) {
            Links links = attribute.of(light);
            items.add(mode(Texts.of("All but the checked"), false, links));
            items.add(mode(Texts.of("Only the checked"), true, links));
            items.add(new SeparatorMenuItem());
            offer(links, items);
        }
        choice.getItems().setAll(items);
    }

    private MenuItem mode(String title, boolean only, Links links) {
        return make.mark(Command.LINK, title, links.only() == only, () -> set(l -> new Links(only, l.names())));
    }

    /** All of the scene itself comes first, then what is in groups, as far as whole groups find room. */
    private void offer(Links links, List<MenuItem> items) {
        Stage stage = editor.scene().stage();
        Set<String> open = new HashSet<>();
        int room = MOST - stage.nodes().size();
        List<Group> groups = new ArrayList<>(links.names().stream().flatMap(name -> stage.around(name).stream()).distinct().toList());
        groups(stage.nodes()).forEach(groups::add);
        for (int i = 0; i < groups.size() && room > 0; i++) {
            Group group = groups.get(i);
            if (group.children().size() <= room && open.add(group.name())) {
                room -= group.children().size();
                groups(group.children()).forEach(groups::add);
            }
        }
        int offered = offer(stage.nodes(), 0, links, open, items);
        if (offered < stage.shapeCount()) {
            items.add(CommandItems.nothing(Command.LINK, Texts.of("More can be named in the file")));
        }
    }

    private static Stream<Group> groups(List<Node> nodes) {
        return nodes.stream().limit(MOST).filter(Group.class::isInstance).map(Group.class::cast);
    }

    /** @return how many of them are shapes */
    private int offer(List<Node> nodes, int depth, Links links, Set<String> open, List<MenuItem> items) {
        int shapes = 0;
        for (Node node : nodes.subList(0, Math.min(nodes.size(), MOST))) {
            items.add(make.box(Command.LINK, node.name(), links.names().contains(node.name()), INDENT * depth,
                    checked -> set(l -> l.with(node.name(), checked))));
            shapes += switch (node) {
                case Group g when open.contains(g.name()) -> offer(g.children(), depth + 1, links, open, items);
                case Group _ -> 0;
                case Shape _ -> 1;
            };
        }
        return shapes;
    }

    private void set(UnaryOperator<Links> edit) {
        String name = editor.selection().lightName();
        editor.editOrReport(scene -> LightEdits.with(scene, name, light -> attribute.with(light, edit.apply(attribute.of(light)))));
    }
}
