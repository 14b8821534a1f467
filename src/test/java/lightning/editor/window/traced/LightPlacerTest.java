package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import javafx.event.EventType;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.PickResult;
import lightning.base.math.Vec3;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.ScenePicker;
import lightning.document.manipulation.Viewport;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.widget.PictureView;
import lightning.render.shading.explanation.LightReport;
import lightning.render.shading.explanation.PixelExplainer;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

/** Places lights by dragging their effects in the traced picture. */
class LightPlacerTest extends EditorFixture {
    private static final double BALL_X = 30;
    private static final double BALL_Y = 22;
    private static final int BALL_TOP = 18;

    private Bounds pictureBounds() {
        PictureView view = robot.lookup("#traced-picture").query();
        return view.pictureBoundsProperty().getValue();
    }

    private Point2D toScreen(double x, double y) {
        PictureView view = robot.lookup("#traced-picture").query();
        return view.localToScreen(pictureBounds().getMinX() + x, pictureBounds().getMinY() + y);
    }

    /** Returns the screen position of a pixel's center in the 64 × 48 picture. */
    private Point2D pixel(double x, double y) {
        return toScreen((x + 0.5) * pictureBounds().getWidth() / 64, (y + 0.5) * pictureBounds().getHeight() / 48);
    }

    private Point2D pixel(Vec3 point) {
        var at = new Viewport(pictureBounds().getWidth(), pictureBounds().getHeight()).project(PreviewCamera.of(model().editor().scene()),
                point);
        return toScreen(at.x(), at.y());
    }

    private Vec3 surface(int x, int y) {
        return new ScenePicker(model().editor().scene()).pickPixel(x, y).orElseThrow().point();
    }

    private LightReport report(int light, int x, int y) {
        return new PixelExplainer(model().editor().scene()).explainPixel(x, y).lights().get(light);
    }

    private void selectTool(String light, Command tool) {
        robot.interact(() -> {
            model().editor().selection().selectLight(light);
            model().commands().run(tool);
        });
    }

    private void assertOneUndoTo(Scene before) {
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(model().editor().scene()).isEqualTo(before);
        assertThat(model().commands().isEnabled(Command.UNDO)).isFalse();
    }

    /** The robot's mouse ignores pressed modifier keys. */
    private void dragWithShift(MouseButton button, Point2D from, Point2D to) {
        robot.interact(() -> {
            mouse(MouseEvent.MOUSE_PRESSED, button, from, true);
            mouse(MouseEvent.MOUSE_DRAGGED, button, to, false);
            mouse(MouseEvent.MOUSE_RELEASED, button, to, false);
        });
    }

    private void mouse(EventType<MouseEvent> type, MouseButton button, Point2D at, boolean still) {
        PictureView picture = robot.lookup("#traced-picture").query();
        Point2D place = picture.localToScene(picture.screenToLocal(at));
        picture.fireEvent(new MouseEvent(type, place.getX(), place.getY(), at.getX(), at.getY(), button, 1, true, false, false, false,
                button == MouseButton.PRIMARY, false, button == MouseButton.SECONDARY, false, false, still, new PickResult(picture,
                        place.getX(), place.getY())));
    }

    /** Returns the size of a displayed pixel at the lamp's depth. Dragged positions are rounded below it. */
    private double pixelSize() {
        PreviewCamera view = PreviewCamera.of(model().editor().scene());
        return view.pixelScale(view.depth(light("lamp").position()), pictureBounds().getHeight());
    }

    @Test
    void draggedHighlight_followsPointerAtFixedDistanceInOneUndoStep() {
        Scene before = model().editor().scene();
        selectTool("lamp", Command.PLACE_HIGHLIGHT);
        robot.moveTo(pixel(BALL_X, BALL_Y)).press(MouseButton.PRIMARY);
        double distance = light("lamp").position().minus(surface(30, 22)).length();
        assertThat(report(0, 30, 22).specular()).isGreaterThan(0.99f);
        robot.moveTo(pixel(34, 21));
        assertThat(report(0, 34, 21).specular()).isGreaterThan(0.99f);
        robot.moveTo(pixel(29, 20)).release(MouseButton.PRIMARY);
        assertThat(report(0, 29, 20).specular()).isGreaterThan(0.99f);
        assertThat(light("lamp").position().minus(surface(29, 20)).length()).isCloseTo(distance, within(pixelSize() / 1000));
        assertThat(isShown("prompt")).isFalse();
        assertGoShowsTheScene();
        assertOneUndoTo(before);
    }

    @Test
    void drag_updatesPictureToFullTrace() {
        robot.interact(() -> model().editor().liveProperty().set(true));
        selectTool("lamp", Command.PLACE_HIGHLIGHT);
        robot.moveTo(pixel(BALL_X, BALL_Y)).press(MouseButton.PRIMARY).moveTo(pixel(35, 20));
        waitForPicture();
        robot.interact(() -> model().commands().run(Command.UPDATE_REFLECTIONS));
        waitFor("the mirrors are current", () -> !model().commands().isEnabled(Command.UPDATE_REFLECTIONS)
                && model().editor().editorStateProperty().get().sceneInProgress().isEmpty());
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
        robot.release(MouseButton.PRIMARY);
    }

    @Test
    void escape_duringDrag_cancelsWithoutUndoStep() {
        Scene before = model().editor().scene();
        selectTool("lamp", Command.PLACE_HIGHLIGHT);
        robot.moveTo(pixel(BALL_X, BALL_Y)).press(MouseButton.PRIMARY).moveTo(pixel(35, 20));
        assertThat(model().editor().scene()).isNotEqualTo(before);
        robot.push(KeyCode.ESCAPE);
        assertThat(model().editor().scene()).isEqualTo(before);
        robot.moveTo(pixel(28, 22)).release(MouseButton.PRIMARY);
        assertThat(model().editor().scene()).isEqualTo(before);
        assertThat(model().commands().isEnabled(Command.UNDO)).isFalse();
        assertThat(isShown("prompt")).isFalse();
    }

    @Test
    void escape_duringWireframeDrag_cancelsWithoutUndoStep() {
        Scene before = model().editor().scene();
        robot.interact(() -> model().editor().selection().selectLight("lamp"));
        robot.moveTo(pixel(light("lamp").position())).press(MouseButton.SECONDARY).moveBy(30, 10);
        assertThat(model().editor().scene()).isNotEqualTo(before);
        robot.push(KeyCode.ESCAPE).moveBy(10, 0).release(MouseButton.SECONDARY);
        assertThat(model().editor().scene()).isEqualTo(before);
        assertThat(model().commands().isEnabled(Command.UNDO)).isFalse();
    }

    @Test
    void draggedCaster_movesItsShadowToPointer() {
        Scene before = model().editor().scene();
        selectTool("lamp", Command.PLACE_SHADOW);
        Vec3 thrower = surface(32, 22);
        robot.moveTo(pixel(32, 22)).press(MouseButton.PRIMARY).moveTo(pixel(46, 36)).release(MouseButton.PRIMARY);
        Vec3 fallen = surface(46, 36);
        Vec3 toThrower = thrower.minus(fallen).normalized();
        Vec3 toLight = light("lamp").position().minus(fallen).normalized();
        assertThat(toThrower.dot(toLight)).isGreaterThan(0.999);
        assertThat(report(0, 46, 36).state()).isEqualTo(LightReport.State.SHADOWED);
        assertOneUndoTo(before);
    }

    @Test
    void draggedShadow_keepsItsCaster() {
        selectTool("lamp", Command.PLACE_SHADOW);
        robot.moveTo(pixel(32, 22)).press(MouseButton.PRIMARY).moveTo(pixel(46, 36)).release(MouseButton.PRIMARY);
        assertThat(report(0, 46, 36).state()).isEqualTo(LightReport.State.SHADOWED);
        selectTool("lamp", Command.PLACE_SHADOW);
        robot.moveTo(pixel(46, 36)).press(MouseButton.PRIMARY).moveTo(pixel(20, 36)).release(MouseButton.PRIMARY);
        assertThat(report(0, 20, 36).state()).isEqualTo(LightReport.State.SHADOWED);
        assertThat(light("lamp").position().x()).as("the light is on the other side now").isGreaterThan(0);
    }

    @Test
    void draggedPool_aimsSpotAtPointer() {
        Scene before = model().editor().scene();
        selectTool("stage", Command.AIM);
        robot.moveTo(pixel(32, 24)).press(MouseButton.PRIMARY).moveTo(pixel(24, 38)).release(MouseButton.PRIMARY);
        Vec3 way = surface(24, 38).minus(light("stage").position()).normalized();
        assertThat(light("stage").direction().normalized().dot(way)).isGreaterThan(0.999);
        assertThat(light("stage").position()).isEqualTo(before.light("stage").orElseThrow().position());
        assertOneUndoTo(before);
    }

    @Test
    void placedDiffuse_facesLight() {
        selectTool("lamp", Command.PLACE_DIFFUSE);
        robot.clickOn(pixel(34, 20));
        assertThat(report(0, 34, 20).cosine()).isGreaterThan(0.999f);
    }

    @Test
    void highlightBelowFloor_namesFloorAndStaysAbove() {
        var picker = new ScenePicker(model().editor().scene());
        int y = IntStream.range(BALL_TOP, 48).filter(row -> picker.pickPixel((int) BALL_X, row).orElseThrow().normal().y() < -0.3)
                .findFirst().orElseThrow();
        selectTool("lamp", Command.PLACE_HIGHLIGHT);
        robot.clickOn(pixel(BALL_X, y));
        assertThat(report(0, (int) BALL_X, y).state()).isEqualTo(LightReport.State.LIT);
        assertThat(model().editor().message().textProperty().get())
                .matches("Distance .*: moved in front of floor, which would block the light");
    }

    @Test
    void placedRim_grazesFromBehind() {
        selectTool("lamp", Command.PLACE_RIM);
        robot.clickOn(pixel(32, 17));
        assertThat(Math.abs(report(0, 32, 17).cosine())).isLessThan(0.05f);
        assertThat(light("lamp").position().z()).isLessThan(surface(32, 17).z());
    }

    @Test
    void ringDrag_changesDistanceInOneUndoStep() {
        selectTool("lamp", Command.PLACE_DIFFUSE);
        robot.clickOn(pixel(34, 20));
        Scene placed = model().editor().scene();
        Vec3 point = surface(34, 20);
        Vec3 way = light("lamp").position().minus(point);
        Point2D middle = pixel(34, 20);
        robot.moveTo(middle.add(LightPlacer.RING_RADIUS, 0)).press(MouseButton.PRIMARY).moveTo(middle.add(1.5 * LightPlacer.RING_RADIUS, 0))
                .release(MouseButton.PRIMARY);
        Vec3 now = light("lamp").position().minus(point);
        assertThat(now.length() / way.length()).isCloseTo(1.5, within(0.05));
        assertThat(now.normalized().dot(way.normalized())).isGreaterThan(0.999);
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(model().editor().scene()).isEqualTo(placed);
    }

    @Test
    void distance_isShownUntilTheRingGoes() {
        selectTool("lamp", Command.PLACE_DIFFUSE);
        robot.clickOn(pixel(34, 20));
        assertThat(model().editor().message().textProperty().get()).startsWith("Distance ");
        robot.push(KeyCode.ESCAPE);
        assertThat(model().editor().message().textProperty().get()).isEmpty();
    }

    @Test
    void shift_duringWireframeDrag_snapsToGrid() {
        robot.interact(() -> model().editor().selection().selectLight("lamp"));
        Point2D from = pixel(light("lamp").position());
        dragWithShift(MouseButton.SECONDARY, from, from.add(33, 11));
        assertThat(model().editor().message().textProperty().get()).startsWith("Snapped: at ");
        String message = model().editor().message().textProperty().get();
        double step = Double.parseDouble(message.substring(message.lastIndexOf(' ') + 1));
        Vec3 at = light("lamp").position();
        for (double v : new double[] {at.x(), at.y(), at.z()}) {
            assertThat(v / step).isCloseTo(Math.rint(v / step), within(1e-9));
        }
    }

    @Test
    void shift_duringPoolDrag_snapsRotation() {
        selectTool("stage", Command.AIM);
        dragWithShift(MouseButton.PRIMARY, pixel(32, 24), pixel(24, 38));
        assertThat(model().editor().message().textProperty().get()).matches("Snapped: azimuth -?\\d+°, elevation -?\\d+°");
        Vec3 way = light("stage").direction().normalized();
        double elevation = Math.toDegrees(Math.asin(way.y())) / 15;
        assertThat(elevation).isCloseTo(Math.rint(elevation), within(1e-9));
    }

    @Test
    void pressOnBackground_keepsTool() {
        Scene before = model().editor().scene();
        selectTool("lamp", Command.PLACE_HIGHLIGHT);
        robot.clickOn(pixel(2, 1));
        assertThat(model().editor().scene()).isEqualTo(before);
        assertThat(model().editor().message().textProperty().get()).isEqualTo("No object here");
        assertThat(isShown("prompt")).isTrue();
    }
}
