package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.layer.ConeChange;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
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
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
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

    /** The rows of the other shapes were not tested when they were joined with those of the shown one. */
    @Test
    void shapesLinkedAfterAnotherWasShown_castRaysFromFacingRows() {
        Scene scene = StudioScene.of(LightType.POINT);
        Shape small = new Shape(Solid.SPHERE, "small", "small", new Placement(new Vec3(1.5, 0.5, 1), Vec3.ZERO, Vec3.ONE.times(0.3)));
        List<SceneNode> nodes = new ArrayList<>(scene.nodes());
        nodes.add(small.withVisible(false));
        List<Material> materials = new ArrayList<>(scene.materials());
        materials.add(Material.of("small"));
        scene = scene.withPicture(scene.picture().withDepth(0)).withMaterials(materials).withNodes(nodes)
                .withLight(scene.lights().getFirst().withIlluminates(ShapeLinks.only("small")));
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene)) {
            long tested = shadowRays(studio.render(scene.withNode("small", small)));
            assertThat(tested).isPositive();
            long facing = studio.referenceRows().count(0, studio.referenceRows().isFacing(studio.key()));
            assertThat(shadowRays(illuminate(studio, ShapeLinks.ALL))).isEqualTo(facing - tested);
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "links");
        }
    }
}
