package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javafx.event.Event;
import javafx.event.EventType;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Labeled;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TabPane;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.editor.Command;
import lightning.editor.window.model.PanelArrangement;
import lightning.editor.window.model.PanelPlace;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.widget.PanelWindow;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Panels in the editor's window, their presets, keys, and windows of their own. */
class DockedPanelsTest extends EditorFixture {
    private static final Command[] DOCKABLE = PanelArrangement.INITIAL.slots().stream().map(PanelArrangement.Slot::panel)
            .toArray(Command[]::new);

    @AfterEach
    void closeWindows() {
        closePanels();
    }

    private void run(Command command) {
        robot.interact(() -> model().commands().run(command));
        FastRobot.settle();
    }

    private PanelArrangement panels() {
        return model().layout().panelsProperty().get();
    }

    private boolean isInWindow(String query) {
        return robot.lookup(query).tryQuery().filter(n -> n.getScene() == stage.getScene()).isPresent();
    }

    private static List<Stage> panelWindows() {
        return Window.getWindows().stream().filter(PanelWindow.class::isInstance).map(Stage.class::cast).toList();
    }

    private void resize(double width, double height) {
        robot.interact(() -> {
            stage.setWidth(width);
            stage.setHeight(height);
        });
        waitFor("the window has its size", () -> stage.getScene().getWidth() == width && stage.getScene().getHeight() == height);
    }

    private Bounds bounds(String query) {
        Node node = robot.lookup(query).query();
        return ScreenBounds.of(node);
    }

    private Node focusOwner() {
        return stage.getScene().getFocusOwner();
    }

    private static boolean isIn(Node node, String id) {
        return node != null && (id.equals(node.getId()) || isIn(node.getParent(), id));
    }

    @Test
    void everyPanel_opensBesidePicturesInSmallestWindow() {
        resize(960, 540);
        for (Command panel : DOCKABLE) {
            run(panel);
            waitFor(panel + " is shown", () -> panels().isShown(panel));
            assertThat(panelWindows()).isEmpty();
            String dock = "#dock-" + panels().place(panel).name().toLowerCase(java.util.Locale.ROOT);
            for (String picture : new String[] {"#traced-picture", "#preview-canvas"}) {
                assertThat(bounds(picture).intersects(bounds(dock))).as(panel + " covers " + picture).isFalse();
                assertThat(bounds(picture).getHeight()).as(panel + " leaves " + picture).isGreaterThan(60);
            }
            closePanels();
        }
    }

    @Test
    void panelBehindAnother_isNotInWindow() {
        run(Command.MIXER);
        waitFor("the mixer is shown", () -> isInWindow("#mixer"));
        run(Command.LOOKS);
        waitFor("looks are shown", () -> isInWindow("#looks") && !isInWindow("#mixer"));
        robot.clickOn("#tab-mixer");
        waitFor("the mixer is shown again", () -> isInWindow("#mixer"));
        assertThat(panels().front(PanelPlace.BELOW)).contains(Command.MIXER);
    }

    @Test
    @OwnEditor
    void key_opensFocusesAndCloses() {
        robot.push(KeyCode.F4);
        waitFor("a fader has the focus", () -> isIn(focusOwner(), "mixer"));
        robot.interact(() -> preview().requestFocus());
        robot.push(KeyCode.F4);
        waitFor("a fader has the focus again", () -> isIn(focusOwner(), "mixer"));
        robot.push(KeyCode.F4);
        waitFor("the mixer is closed", () -> !isInWindow("#mixer"));
        assertThat(robot.lookup("#dock-below").tryQuery()).as("an empty dock takes no room").isEmpty();
    }

    @Test
    void presets_showTheirPanels() {
        robot.push(KeyCode.CONTROL, KeyCode.ALT, KeyCode.DIGIT1);
        waitFor("the mixer is shown", () -> isInWindow("#mixer") && isInWindow("#preview-canvas"));
        robot.push(KeyCode.CONTROL, KeyCode.ALT, KeyCode.DIGIT2);
        waitFor("looks are shown", () -> isInWindow("#looks") && isInWindow("#scopes") && !isInWindow("#preview-canvas"));
        robot.push(KeyCode.CONTROL, KeyCode.ALT, KeyCode.DIGIT3);
        waitFor("the timeline is shown", () -> isInWindow("#timeline") && isInWindow("#preview-canvas") && !isInWindow("#scopes"));
        assertThat(model().layout().filmStripShownProperty().get()).isTrue();
    }

    @Test
    void preset_keepsFocusOnVisiblePart() {
        robot.interact(() -> preview().requestFocus());
        run(Command.ARRANGE_COMPARE);
        assertThat(isIn(focusOwner(), "toolbar")).as("focus on " + focusOwner()).isFalse();
    }

    @Test
    void tornOffPanel_returnsToItsDock() {
        run(Command.MIXER);
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.W);
        waitFor("the mixer has a window", () -> panelWindows().size() == 1 && panelWindows().getFirst().isFocused());
        assertThat(panelWindows().getFirst().getTitle()).isEqualTo("Light Mixer");
        assertThat(robot.lookup("#dock-below").tryQuery()).isEmpty();
        assertThat(isShown("mixer")).isTrue();
        robot.clickOn("#float-panel");
        waitFor("the mixer is docked", () -> panelWindows().isEmpty() && isInWindow("#mixer"));
    }

    @Test
    void closedWindow_opensAsWindowAgain() {
        run(Command.HISTORY_PANEL);
        run(Command.FLOAT_PANEL);
        waitFor("the history has a window", () -> panelWindows().size() == 1 && panelWindows().getFirst().isFocused());
        robot.push(KeyCode.ESCAPE);
        waitFor("the window is closed", () -> panelWindows().isEmpty());
        assertThat(panels().openIn(PanelPlace.WINDOW)).isEmpty();
        run(Command.HISTORY_PANEL);
        waitFor("the window is open again", () -> panelWindows().size() == 1);
    }

    /** Sends a mouse event to the tabs at a position of the screen. */
    private void mouse(EventType<MouseEvent> type, Point2D screen) {
        Node dock = robot.lookup("#tab-mixer").query().getParent();
        Point2D scene = stage.getScene().getRoot().screenToLocal(screen);
        robot.interact(() -> Event.fireEvent(dock, new MouseEvent(type, scene.getX(), scene.getY(), screen.getX(), screen.getY(),
                MouseButton.PRIMARY, 1, false, false, false, false, true, false, false, false, false, false, null)));
    }

    private void dragMixer(Point2D to) {
        Bounds tab = bounds("#tab-mixer");
        mouse(MouseEvent.MOUSE_PRESSED, new Point2D(tab.getCenterX(), tab.getCenterY()));
        mouse(MouseEvent.MOUSE_DRAGGED, to);
        assertThat(robot.lookup(".dock-target").query().isVisible()).as("the target is marked").isTrue();
        mouse(MouseEvent.MOUSE_RELEASED, to);
        FastRobot.settle();
    }

    @Test
    void draggedTab_movesToOtherDockAndOut() {
        run(Command.MIXER);
        Bounds picture = bounds("#traced-picture");
        dragMixer(new Point2D(picture.getMinX() + 20, picture.getCenterY()));
        assertThat(panels().front(PanelPlace.LEFT)).contains(Command.MIXER);
        Bounds lights = bounds("#lights");
        dragMixer(new Point2D(lights.getCenterX(), lights.getCenterY()));
        waitFor("the mixer has a window", () -> panelWindows().size() == 1);
    }

    @Test
    @OwnEditor
    void arrangement_afterRestart_isRestored() throws Exception {
        run(Command.LOOKS);
        run(Command.MIXER);
        run(Command.SCOPES);
        run(Command.FLOAT_PANEL);
        waitFor("the scopes have a window", () -> panelWindows().size() == 1);
        PanelArrangement used = panels();
        robot.interact(() -> ((SplitPane) robot.lookup("#dock-below").query().getParent().getParent()).setDividerPositions(0.7));
        double height = bounds("#dock-below").getHeight();
        robot.interact(() -> model().layout().panelsHiddenProperty().set(true));
        robot.interact(() -> model().layout().panelsHiddenProperty().set(false));
        robot.interact(() -> model().commands().run(Command.LIGHT_THEME));
        robot.interact(() -> model().commands().run(Command.LIGHT_THEME));
        waitFor("the size is saved",
                () -> Math.abs(new Preferences(folder.resolve("own"), Runnable::run).number("dock.BELOW", 0, 9999, 0) - height) < 2);
        close();
        open();
        assertThat(panels()).isEqualTo(used);
        waitFor("the panels are shown", () -> isInWindow("#mixer") && panelWindows().size() == 1);
        assertThat(bounds("#dock-below").getHeight()).isBetween(height - 2, height + 2);
    }

    @Test
    void nextPanel_visitsEveryPart() {
        run(Command.MIXER);
        run(Command.HISTORY_PANEL);
        robot.interact(() -> preview().requestFocus());
        List<String> visited = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            robot.push(KeyCode.CONTROL, KeyCode.ALT, KeyCode.P);
            FastRobot.settle();
            visited.add(Stream.of("lists", "side", "dock-left", "dock-below", "preview").filter(id -> isIn(focusOwner(), id)).findFirst()
                    .orElse("none"));
        }
        assertThat(visited).containsExactly("lists", "side", "dock-left", "dock-below", "preview");
        robot.push(KeyCode.CONTROL, KeyCode.ALT, KeyCode.SHIFT, KeyCode.P);
        assertThat(isIn(focusOwner(), "dock-below")).isTrue();
    }

    @Test
    void controlTab_switchesPanelsOfDock() {
        run(Command.MIXER);
        run(Command.LOOKS);
        robot.interact(() -> robot.lookup("#dock-below").<TabPane>query().requestFocus());
        robot.push(KeyCode.CONTROL, KeyCode.TAB);
        waitFor("the mixer is in front", () -> panels().isShown(Command.MIXER));
    }

    @Test
    void dockedControls_areNamed() {
        List<String> unnamed = new ArrayList<>();
        for (Command panel : DOCKABLE) {
            run(panel);
            String dock = "#dock-" + panels().place(panel).name().toLowerCase(java.util.Locale.ROOT);
            robot.interact(() -> nodes(robot.lookup(dock).query()).filter(n -> n.isFocusTraversable() && !(n instanceof ScrollPane))
                    .filter(n -> (n.getAccessibleText() == null || n.getAccessibleText().isEmpty())
                            && !(n instanceof Labeled l && l.getText() != null && !l.getText().isEmpty()))
                    .forEach(n -> unnamed.add(panel + ": " + n)));
            closePanels();
        }
        assertThat(unnamed).isEmpty();
    }

    private static Stream<Node> nodes(Node node) {
        return Stream.concat(Stream.of(node), node instanceof Parent p ? p.getChildrenUnmodifiable().stream().filter(Node::isVisible)
                .flatMap(DockedPanelsTest::nodes) : Stream.empty());
    }
}
