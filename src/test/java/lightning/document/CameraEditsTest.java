package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Vec3;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.NamedCamera;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import lightning.scene.value.Lens;
import org.junit.jupiter.api.Test;

class CameraEditsTest {
    private static final Scene SCENE =
            StudioScene.of(LightType.POINT).withCamera(new Camera(new Vec3(1, 2, 10), new Vec3(1, 2, 0), Vec3.Y, 40));

    private static Scene focused(Scene scene, Vec3 point) {
        return ((EditOutcome.Applied) CameraEdits.focus(scene, point)).scene();
    }

    /** The plane of focus is perpendicular to the view, so a point at the side does not move it. */
    @Test
    void focusDistance_isAlongTheView() {
        assertThat(focused(SCENE, new Vec3(4, 0, 3)).camera().lens().focus()).isEqualTo(7);
    }

    @Test
    void pinhole_isOpenedAndAntialiased() {
        Scene scene = focused(SCENE, new Vec3(1, 2, 5));
        assertThat(scene.camera().lens()).isEqualTo(new Lens(0.05, 5, 0, 0));
        assertThat(scene.picture().sampling()).isEqualTo(new SamplingSettings(AntialiasMode.EDGES, 4));
    }

    @Test
    void openLens_keepsApertureAndSampling() {
        Lens lens = new Lens(0.3, 2, 7, 20);
        Scene open = SCENE.withCamera(SCENE.camera().withLens(lens))
                .withPicture(SCENE.picture().withSampling(new SamplingSettings(AntialiasMode.EVERY, 2)));
        Scene scene = focused(open, new Vec3(1, 2, 5));
        assertThat(scene.camera().lens()).isEqualTo(lens.withFocus(5));
        assertThat(scene.picture()).isEqualTo(open.picture());
    }

    private static Scene applied(EditOutcome outcome) {
        return ((EditOutcome.Applied) outcome).scene();
    }

    @Test
    void keptCamera_isChosenAgain_andReplacedUnderItsName() {
        Camera other = SCENE.camera().withView(new Vec3(5, 5, 5), Vec3.ZERO, Vec3.Y);
        Scene kept = applied(CameraEdits.keep(SCENE, "front"));
        Scene moved = kept.withCamera(other);
        assertThat(CameraEdits.keptName(kept)).isEqualTo("front");
        assertThat(CameraEdits.keptName(moved)).isEmpty();
        assertThat(applied(CameraEdits.choose(moved, "front"))).isEqualTo(kept);
        assertThat(applied(CameraEdits.keep(moved, "front")).cameras()).containsExactly(new NamedCamera("front", other));
        assertThat(applied(CameraEdits.delete(kept, "front"))).isEqualTo(SCENE);
    }

    @Test
    void namedCameras_doNotChangeThePicture() {
        assertThat(applied(CameraEdits.keep(SCENE, "front")).hasSameImage(SCENE)).isTrue();
    }

    @Test
    void unknownCamera_isRefused() {
        assertThat(CameraEdits.choose(SCENE, "front")).isEqualTo(new EditOutcome.Refused("there is no camera 'front'"));
    }

    @Test
    void pointBehindTheCamera_isRefused() {
        assertThat(CameraEdits.focus(SCENE, new Vec3(1, 2, 12))).isInstanceOf(EditOutcome.Refused.class);
    }
}
