package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Control;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.input.MouseButton;
import javafx.stage.Window;
import lightning.base.math.Vec3;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Every menu item of the editor is a command. */
class MenusTest extends EditorFixture {
    @AfterEach
    void closeWindows() {
        robot.interact(() -> List.copyOf(Window.getWindows()).stream().filter(window -> window != stage).forEach(Window::hide));
    }

    private List<MenuItem> items() {
        List<MenuItem> all = new ArrayList<>();
        for (Window window : Window.getWindows()) {
            if (window instanceof ContextMenu menu) {
                collect(menu.getItems(), all);
            }
            collect(window.getScene().getRoot(), all);
        }
        return all;
    }

    private static void collect(Node node, List<MenuItem> all) {
        if (node instanceof MenuBar bar) {
            bar.getMenus().forEach(menu -> collect(menu.getItems(), all));
        }
        if (node instanceof MenuButton button) {
            // This menu is filled when it opens.
            if (button.getOnShowing() != null) {
                button.getOnShowing().handle(null);
            }
            collect(button.getItems(), all);
        }
        if (node instanceof Control control && control.getContextMenu() != null) {
            collect(control.getContextMenu().getItems(), all);
        }
        if (node instanceof Parent parent) {
            parent.getChildrenUnmodifiable().forEach(child -> collect(child, all));
        }
    }

    private static void collect(List<MenuItem> items, List<MenuItem> all) {
        for (MenuItem item : items) {
            if (item instanceof Menu menu) {
                collect(menu.getItems(), all);
            } else if (!(item instanceof SeparatorMenuItem)) {
                all.add(item);
            }
        }
    }

    /** Returns the items of a shape's menu and of all menus that exist with every tab and window open. */
    private List<MenuItem> allItems() {
        robot.interact(() -> model().editor().materialShownProperty().set(true));
        robot.clickOn(toScreen(new Vec3(0, 1, 0)), MouseButton.SECONDARY);
        waitFor("the shape's menu is open", () -> items().stream().anyMatch(i -> "Edit Material matt of ball".equals(i.getText())));
        List<MenuItem> all = new ArrayList<>();
        robot.interact(() -> all.addAll(items()));
        closeWindows();
        robot.moveTo("#traced-picture").clickOn(MouseButton.SECONDARY);
        waitFor("the pixel's menu is open", () -> items().stream().anyMatch(i -> "Hide ball".equals(i.getText())));
        robot.interact(() -> all.addAll(items()));
        robot.interact(() -> model().editor().materialShownProperty().set(false));
        robot.clickOn("#intensity .label", MouseButton.SECONDARY);
        robot.interact(() -> {
            all.addAll(items());
            Stream.of(Command.ACCURACY_PANEL, Command.EFFECTS_PANEL, Command.KEYS)
                    .forEach(model().commands()::run);
            all.addAll(items());
        });
        robot.interact(() -> model().commands().run(Command.EDIT_WORLD));
        robot.interact(() -> all.addAll(items()));
        return all;
    }

    @Test
    void everyItem_hasCommand() {
        assertThat(allItems()).hasSizeGreaterThan(100)
                .allSatisfy(item -> assertThat(CommandMenuItems.command(item)).as("the command of %s", item.getText()).isPresent());
    }

    @Test
    void everyCommand_isInAMenuOfTheEditor() {
        Set<Command> offered = EnumSet.noneOf(Command.class);
        allItems().forEach(item -> CommandMenuItems.command(item).ifPresent(offered::add));
        // The light's type is chosen in its properties instead.
        offered.add(Command.CHANGE_TYPE);
        assertThat(offered).containsExactlyInAnyOrder(Command.values());
    }

    @Test
    void preloadedMenu_opensWithCurrentStyledItems() {
        List<Menu> menus = robot.lookup(".menu-bar").<MenuBar>query().getMenus();
        Set<Double> notMadeAhead = heights(opened(menus.get(1)));
        ContextMenu window = window(menus.get(2));
        assertThat(window.getSkin()).isNull();
        robot.interact(() -> editor.window().preloadSteps().forEach(Runnable::run));
        assertThat(window.isShowing()).isFalse();
        Node made = window.getSkin().getNode();
        Node seen = opened(menus.get(2));
        assertThat(seen).isSameAs(made);
        assertThat(heights(seen)).isEqualTo(notMadeAhead);
    }

    private static ContextMenu window(Menu menu) {
        return menu.getItems().getFirst().getParentPopup();
    }

    private Node opened(Menu menu) {
        robot.interact(menu::show);
        waitFor("the menu is open", () -> window(menu).isShowing());
        return window(menu).getSkin().getNode();
    }

    /** Returns the heights of a menu's items. */
    private static Set<Double> heights(Node menu) {
        return ((Parent) ((Parent) menu).getChildrenUnmodifiable().getFirst()).getChildrenUnmodifiable().stream()
                .map(line -> line.getBoundsInParent().getHeight()).collect(Collectors.toSet());
    }

    @Test
    void item_isDisabledWithItsCommand() {
        robot.interact(() -> model().editor().selection().selectLight("lamp"));
        robot.interact(() -> {
            for (MenuItem item : items()) {
                boolean empty = Arrays.asList("No Recent Scenes", "No Named Cameras: World > Camera saves them").contains(item.getText());
                assertThat(item.isDisable()).as(item.getText())
                        .isEqualTo(empty || !model().commands().isEnabled(CommandMenuItems.command(item).orElseThrow()));
            }
        });
    }

    @Test
    void keys_areUnique() {
        List<String> keys = Arrays.stream(Command.values()).map(Command::shortcut).filter(k -> !k.isEmpty()).toList();
        assertThat(keys).doesNotHaveDuplicates();
    }

    @Test
    void toggleItem_isCheckedWhileOn() {
        MenuItem live = items().stream().filter(i -> "menu-live".equals(i.getId())).findFirst().orElseThrow();
        assertThat(((CheckMenuItem) live).isSelected()).isFalse();
        robot.interact(live::fire);
        assertThat(model().editor().liveProperty().get()).isTrue();
        assertThat(((CheckMenuItem) live).isSelected()).isTrue();
        click("live");
        assertThat(((CheckMenuItem) live).isSelected()).isFalse();
    }
}
