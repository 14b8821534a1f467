package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Vec3;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.ConeChange;
import lightning.sample.StudioScene;
import lightning.scene.LightType;
import lightning.scene.Links;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Edits of a light's links do the least work. */
class LinkWorkTest {
    private static final LightUpdate LINKS = new LightUpdate.Partial(ConeChange.LINKS, false, false);
    private static final LightUpdate SHADOWS = new LightUpdate.Partial(ConeChange.NONE, false, false, true);

    private static Update illuminate(Studio studio, Links links) {
        return studio.edit(l -> l.withIlluminates(links));
    }

    private static Update shadow(Studio studio, Links links) {
        return studio.edit(l -> l.withShadowedBy(links));
    }

    private static long shadowRays(Update update) {
        return update.rays().shadow();
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void shapeOutOfTheLight_andBack_castsNoShadowRay(LightType type) {
        try (Studio studio = Studio.of(type)) {
            Update out = illuminate(studio, Links.except("ball"));
            assertThat(Studio.layers(out)).containsExactly(LINKS);
            assertThat(shadowRays(out)).isZero();
            Update back = illuminate(studio, Links.ALL);
            assertThat(Studio.layers(back)).containsExactly(LINKS);
            assertThat(shadowRays(back)).isZero();
        }
    }

    @Test
    void shapesThatWereNeverLit_areAskedOnce() {
        try (Studio studio = Studio.of(LightType.POINT)) {
            studio.edit(l -> l.withIlluminates(Links.only("ball")).withPosition(new Vec3(2, 4.5, 2)));
            long lit = shadowRays(illuminate(studio, Links.ALL));
            assertThat(lit).isPositive();
            illuminate(studio, Links.NONE);
            assertThat(shadowRays(illuminate(studio, Links.ALL))).isZero();
        }
    }

    @Test
    void firstLink_asksWhoseRowsTheyAre_theNextNothing() {
        try (Studio studio = Studio.of(LightType.POINT)) {
            Update first = illuminate(studio, Links.only("ball"));
            assertThat(first.rays().eye()).isPositive();
            assertThat(first.rays().shadow()).isZero();
            assertThat(illuminate(studio, Links.only("floor")).rays().all()).isZero();
        }
    }

    @Test
    void shapeThatThrowsNoShadowAnyMore_asksOnlyBlockedRows() {
        try (Studio studio = Studio.of(LightType.POINT)) {
            long shadowed = studio.seen().count(0, studio.seen().shadowed(studio.key()));
            Update update = shadow(studio, Links.except("mirror"));
            assertThat(Studio.layers(update)).containsExactly(SHADOWS);
            assertThat(shadowRays(update)).isBetween(1L, shadowed);
        }
    }

    @Test
    void linkOfADarkLight_waitsUntilItShines() {
        try (Studio studio = Studio.of(LightType.SPOT)) {
            studio.edit(l -> l.withOn(false));
            Update dark = shadow(studio, Links.NONE);
            assertThat(Studio.layers(dark)).containsExactly(new LightUpdate.Keep());
            assertThat(dark.rays().all()).isZero();
            assertThat(Studio.layers(studio.edit(l -> l.withOn(true)))).containsExactly(SHADOWS);
        }
    }

    @Test
    void otherLights_keepTheirLayers() {
        Studio studio = new Studio(lightning.render.relight.plan.Reflections.CURRENT, lightning.render.relight.tile.MirrorStorage.FULL_ROWS,
                StudioScene.withFourLights(30, 24));
        try (studio) {
            assertThat(Studio.layers(illuminate(studio, Links.only("floor"))).stream().skip(1)).containsOnly(new LightUpdate.Keep());
        }
    }
}
