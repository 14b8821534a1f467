package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Vec3;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.layer.ConeChange;
import lightning.sample.StudioScene;
import lightning.scene.light.LightType;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests that edits of a light's links do the least work. */
class LightLinkWorkTest {
    private static final LightUpdate LINKS = new LightUpdate.Partial(ConeChange.LINKS, false, false);
    private static final LightUpdate SHADOWS = new LightUpdate.Partial(ConeChange.NONE, false, false, true);

    private static UpdateResult illuminate(StudioRenderer studio, ShapeLinks links) {
        return studio.edit(l -> l.withIlluminates(links));
    }

    private static UpdateResult shadow(StudioRenderer studio, ShapeLinks links) {
        return studio.edit(l -> l.withShadowedBy(links));
    }

    private static long shadowRays(UpdateResult update) {
        return update.rays().shadow();
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void unlinkedAndRelinkedShape_castsNoShadowRays(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            UpdateResult out = illuminate(studio, ShapeLinks.except("ball"));
            assertThat(StudioRenderer.layers(out)).containsExactly(LINKS);
            assertThat(shadowRays(out)).isZero();
            UpdateResult back = illuminate(studio, ShapeLinks.ALL);
            assertThat(StudioRenderer.layers(back)).containsExactly(LINKS);
            assertThat(shadowRays(back)).isZero();
        }
    }

    @Test
    void neverLitShapes_castShadowRaysOnce() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.POINT)) {
            studio.edit(l -> l.withIlluminates(ShapeLinks.only("ball")).withPosition(new Vec3(2, 4.5, 2)));
            long lit = shadowRays(illuminate(studio, ShapeLinks.ALL));
            assertThat(lit).isPositive();
            illuminate(studio, ShapeLinks.NONE);
            assertThat(shadowRays(illuminate(studio, ShapeLinks.ALL))).isZero();
        }
    }

    @Test
    void firstLink_findsOwnersAndNextLink_doesNothing() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.POINT)) {
            UpdateResult first = illuminate(studio, ShapeLinks.only("ball"));
            assertThat(first.rays().eye()).isPositive();
            assertThat(first.rays().shadow()).isZero();
            assertThat(illuminate(studio, ShapeLinks.only("floor")).rays().total()).isZero();
        }
    }

    @Test
    void removedShadowCaster_castsOnlyForBlockedRows() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.POINT)) {
            long shadowed = studio.referenceRows().count(0, studio.referenceRows().isShadowed(studio.key()));
            UpdateResult update = shadow(studio, ShapeLinks.except("mirror"));
            assertThat(StudioRenderer.layers(update)).containsExactly(SHADOWS);
            assertThat(shadowRays(update)).isBetween(1L, shadowed);
        }
    }

    @Test
    void linkOfDarkLight_isDeferred() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.SPOT)) {
            studio.edit(l -> l.withOn(false));
            UpdateResult dark = shadow(studio, ShapeLinks.NONE);
            assertThat(StudioRenderer.layers(dark)).containsExactly(new LightUpdate.Keep());
            assertThat(dark.rays().total()).isZero();
            assertThat(StudioRenderer.layers(studio.edit(l -> l.withOn(true)))).containsExactly(SHADOWS);
        }
    }

    @Test
    void otherLights_keepLayers() {
        StudioRenderer studio = new StudioRenderer(lightning.render.relight.paper.ReflectionMode.CURRENT,
                lightning.render.relight.paper.MirrorStorage.FULL_ROWS,
                StudioScene.withFourLights(30, 24));
        try (studio) {
            assertThat(StudioRenderer.layers(illuminate(studio, ShapeLinks.only("floor"))).stream().skip(1))
                    .containsOnly(new LightUpdate.Keep());
        }
    }
}
