package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.stage.Window;
import lightning.document.manipulation.ScenePicker;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.widget.PictureView;
import lightning.render.shading.explanation.LightReport;
import lightning.render.shading.explanation.PixelExplainer;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The context menu of a pixel of the traced picture. */
class PixelMenuTest extends EditorFixture {
    private static final int X = 28;
    private static final int Y = 22;

    @AfterEach
    void closeMenus() {
        robot.interact(() -> List.copyOf(Window.getWindows()).stream().filter(ContextMenu.class::isInstance).forEach(Window::hide));
    }

    private Point2D pixel(double x, double y) {
        PictureView view = robot.lookup("#traced-picture").query();
        Bounds bounds = view.pictureBoundsProperty().getValue();
        return view.localToScreen(bounds.getMinX() + (x + 0.5) * bounds.getWidth() / 64,
                bounds.getMinY() + (y + 0.5) * bounds.getHeight() / 48);
    }

    private void openMenu() {
        robot.clickOn(pixel(X, Y), MouseButton.SECONDARY);
        waitFor("the menu is open", () -> !items().isEmpty());
    }

    private List<MenuItem> items() {
        List<MenuItem> all = new ArrayList<>();
        Window.getWindows().stream().filter(ContextMenu.class::isInstance).map(ContextMenu.class::cast)
                .forEach(menu -> addItems(menu.getItems(), all));
        return all;
    }

    private static void addItems(List<MenuItem> items, List<MenuItem> all) {
        for (MenuItem item : items) {
            all.add(item);
            if (item instanceof Menu menu) {
                addItems(menu.getItems(), all);
            }
        }
    }

    private MenuItem item(String start) {
        return items().stream().filter(i -> i.getText() != null && i.getText().startsWith(start)).findFirst()
                .orElseThrow(() -> new AssertionError("no item " + start + " in " + items().stream().map(MenuItem::getText).toList()));
    }

    private void choose(String start) {
        robot.interact(() -> item(start).fire());
    }

    private void select(String light) {
        robot.interact(() -> model().editor().selection().selectLight(light));
    }

    private LightReport report(String light) {
        return new PixelExplainer(model().editor().scene()).explainPixel(X, Y).lights().stream()
                .filter(r -> r.light().name().equals(light)).findFirst().orElseThrow();
    }

    @Test
    void lights_areListedWithTheirShares() {
        select("sun");
        openMenu();
        List<String> shares = items().stream().map(MenuItem::getText).filter(t -> t != null && t.matches("(lamp|sun|stage)  \\d+ %.*"))
                .toList();
        assertThat(shares).isNotEmpty();
        double sum = shares.stream().mapToDouble(t -> Double.parseDouble(t.replaceAll(".*  (\\d+) %.*", "$1"))).sum();
        assertThat(sum).isCloseTo(100, within(1.5));
        choose("stage");
        assertThat(model().editor().selection().lightName()).isEqualTo("stage");
    }

    @Test
    void aimHere_turnsSelectedLight() {
        select("stage");
        openMenu();
        choose("Aim stage Here");
        Scene scene = model().editor().scene();
        var point = new ScenePicker(scene).pickPixel(X, Y).orElseThrow().point();
        Light light = light("stage");
        assertThat(light.direction().normalized().dot(point.minus(light.position()).normalized())).isGreaterThan(0.9999);
    }

    @Test
    void aimHere_isDisabledWithoutDirection() {
        select("lamp");
        openMenu();
        assertThat(item("Aim lamp Here").isDisable()).isTrue();
    }

    @Test
    void highlightHere_isOneUndoStep() {
        select("lamp");
        Scene before = model().editor().scene();
        openMenu();
        choose("Highlight Here");
        assertThat(report("lamp").specular()).isGreaterThan(0.99f);
        assertThat(text("picture-message")).startsWith("Distance");
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(model().editor().scene()).isEqualTo(before);
        assertThat(text("message")).isEmpty();
    }

    @Test
    void shadowHere_fallsOnPixel() {
        select("lamp");
        robot.clickOn(pixel(46, 36), MouseButton.SECONDARY);
        waitFor("the menu is open", () -> !items().isEmpty());
        choose("Shadow Here");
        assertThat(text("prompt")).startsWith("Click the object that should cast");
        robot.clickOn(pixel(32, 22));
        waitFor("the light is placed", () -> model().commands().isEnabled(Command.UNDO));
        assertThat(new PixelExplainer(model().editor().scene()).explainPixel(46, 36).lights().getFirst().state())
                .isEqualTo(LightReport.State.SHADOWED);
        assertThat(isShown("prompt")).isFalse();
    }

    @Test
    void newLightHere_facesSurface() {
        openMenu();
        robot.interact(() -> ((Menu) item("New Light Here")).getItems().stream().filter(i -> i.getText().equals("Spot")).findFirst()
                .orElseThrow().fire());
        Light added = model().editor().scene().lights().getLast();
        assertThat(added.type()).isEqualTo(LightType.SPOT);
        assertThat(model().editor().selection().light()).isEqualTo(added);
        LightReport at = report(added.name());
        assertThat(at.state()).isEqualTo(LightReport.State.LIT);
        assertThat(at.cosine()).isGreaterThan(0.99f);
    }

    @Test
    void linkItem_unlinksLight() {
        select("stage");
        openMenu();
        assertThat(((CheckMenuItem) item("stage Illuminates ball")).isSelected()).isTrue();
        choose("stage Illuminates ball");
        assertThat(light("stage").illuminates()).isEqualTo(ShapeLinks.except("ball"));
        closeMenus();
        openMenu();
        assertThat(((CheckMenuItem) item("stage Illuminates ball")).isSelected()).isFalse();
        choose("stage Illuminates ball");
        assertThat(light("stage").illuminates()).isEqualTo(ShapeLinks.ALL);
    }

    @Test
    void hide_hidesObject() {
        openMenu();
        choose("Hide ball");
        assertThat(model().editor().scene().stage().node("ball").orElseThrow().visible()).isFalse();
        assertThat(text("picture-message")).startsWith("ball is hidden");
    }

    @Test
    void menuKey_opensMenuAtPointer() {
        robot.moveTo(pixel(X, Y));
        waitFor("the pixel is known", () -> model().picturePointer().pixelProperty().get() != null);
        robot.push(KeyCode.SHIFT, KeyCode.F10);
        waitFor("the menu is open", () -> !items().isEmpty());
        assertThat(item("Hide ball").isDisable()).isFalse();
    }

    @Test
    void background_showsMessageOnly() {
        robot.clickOn(pixel(2, 1), MouseButton.SECONDARY);
        waitFor("the message is shown", () -> text("picture-message").equals("No object here"));
        assertThat(items()).isEmpty();
    }
}
