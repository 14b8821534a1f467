package lightning.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.math.Vec3;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.shading.LightReport;
import lightning.shading.PixelExplainer;
import org.junit.jupiter.api.Test;

/** The renderer's own explanation of a pixel is the judge. */
class LightPlacingTest {
    private static final int X = 20;
    private static final int BALL_Y = 15;
    private static final int FLOOR_Y = 27;

    private final Scene scene = Desk.scene();
    private final ScenePicker picker = new ScenePicker(scene);

    private static LightReport report(Scene scene, String light, int y) {
        return new PixelExplainer(scene).pixel(X, y).lights().stream().filter(r -> r.light().name().equals(light))
                .findFirst().orElseThrow();
    }

    @Test
    void pixel_showsTheShapeThatTheRendererFinds() {
        assertThat(picker.atPixel(X, BALL_Y)).map(ScenePicker.Found::shape).contains("ball");
        assertThat(picker.atPixel(X, FLOOR_Y)).map(ScenePicker.Found::shape).contains("ground");
        assertThat(picker.atPixel(X, 0)).isEmpty();
    }

    @Test
    void anotherView_findsWhatLiesThere() {
        var canvas = new Viewport(100, 100);
        ScenePicker.Found found = picker.at(PreviewCamera.alongMinusY(scene), canvas, new Viewport.Pixel(50, 50)).orElseThrow();
        assertThat(found.shape()).isEqualTo("ball");
        PreviewCameraTest.assertClose(found.point(), new Vec3(0, 2, 0), 1e-3);
        PreviewCameraTest.assertClose(found.normal(), Vec3.Y, 1e-3);
    }

    @Test
    void picker_servesScenesOfTheSameShapes() {
        assertThat(picker.serves(scene.withLights(List.of()))).isTrue();
        assertThat(picker.serves(scene.withCamera(PreviewCamera.alongX(scene).camera()))).isFalse();
    }

    @Test
    void highlight_isBrightestWhereItWasPlaced() {
        ScenePicker.Found at = picker.atPixel(X, BALL_Y).orElseThrow();
        for (String name : Desk.names(scene)) {
            Scene placed = Desk.done(LightPlacing.highlight(scene, name, at));
            LightReport report = report(placed, name, BALL_Y);
            assertThat(report.state()).isEqualTo(LightReport.State.LIT);
            assertThat(report.specular()).isCloseTo(1, within(1e-3f));
        }
    }

    @Test
    void highlight_keepsTheDistance() {
        ScenePicker.Found at = picker.atPixel(X, BALL_Y).orElseThrow();
        Light before = Desk.light(scene, "key");
        Light after = Desk.light(Desk.done(LightPlacing.highlight(scene, "key", at)), "key");
        assertThat(after.position().minus(at.point()).length())
                .isCloseTo(before.position().minus(at.point()).length(), within(1e-9));
    }

    @Test
    void shadow_fallsWhereItWasPlaced() {
        ScenePicker.Found floor = picker.atPixel(X, FLOOR_Y).orElseThrow();
        for (String name : Desk.names(scene)) {
            Scene placed = Desk.done(LightPlacing.shadow(scene, name, new Vec3(0, 1, 0), floor.point()));
            assertThat(report(placed, name, FLOOR_Y).state()).isEqualTo(LightReport.State.SHADOWED);
        }
    }

    @Test
    void shadowOnItsOwnThrower_isRefused() {
        assertThat(LightPlacing.shadow(scene, "key", Vec3.ZERO, Vec3.ZERO).refusal())
                .contains("the shadow falls on what throws it");
    }
}
