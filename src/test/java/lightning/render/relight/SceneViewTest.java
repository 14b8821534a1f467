package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.ViewCurve;
import lightning.scene.ViewSettings;
import lightning.scene.VisibleState;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SceneViewTest {
    private final Scene scene = StudioScene.of(LightType.POINT);

    private static Scene withView(Scene scene, ViewCurve curve, double exposure) {
        return scene.withPicture(scene.picture().withView(new ViewSettings(curve, exposure)));
    }

    @Test
    void defaultView_isThatOfScenesBeforeViews() {
        assertThat(SceneView.of(scene)).isEqualTo(ViewTransform.DEFAULT);
    }

    @ParameterizedTest
    @EnumSource
    void everyCurve_isShownByOneDisplayCurve(ViewCurve curve) {
        ViewTransform view = SceneView.of(withView(scene, curve, 0.5));
        assertThat(view.exposure()).isEqualTo(0.5);
        assertThat(SceneView.curve(view.curve())).contains(curve);
        assertThat(SceneView.curve(DisplayCurve.FALSE)).isEmpty();
    }

    @ParameterizedTest
    @EnumSource
    void otherView_castsNoRayAndComposesNothing(ReflectionMode reflections) {
        RenderOptions options = RenderOptions.DEFAULT.withThreads(1);
        try (Renderer renderer = new Renderer(new RenderOptions(Accuracy.EXACT, reflections, options.storage(), 1))) {
            renderer.render(scene, Progress.NONE);
            PixelCache cache = renderer.cache();
            UpdateResult update = renderer.render(withView(scene, ViewCurve.AGX, -3), Progress.NONE);
            assertThat(update.plan()).isEqualTo(new UpdatePlan.Nothing());
            assertThat(update.rays().total()).isZero();
            assertThat(update.rowsComposed()).isZero();
            assertThat(update.rowsTouched()).isZero();
            assertThat(renderer.cache()).isSameAs(cache);
        }
    }

    @Test
    void view_isPartOfSceneButNotOfImage() {
        Scene agx = withView(scene, ViewCurve.AGX, 0);
        assertThat(agx).isNotEqualTo(scene);
        assertThat(agx.hasSameImage(scene)).isTrue();
        assertThat(VisibleState.isSame(agx, scene)).isTrue();
        assertThat(agx.hasSameImage(scene.withPicture(scene.picture().withDepth(7)))).isFalse();
        assertThat(agx.hasSameImage(scene.withWorld(scene.world().withAmbience(0.77)))).isFalse();
        assertThat(agx.picture().withSize(3, 4).withDepth(1).view()).isEqualTo(agx.picture().view());
    }
}
