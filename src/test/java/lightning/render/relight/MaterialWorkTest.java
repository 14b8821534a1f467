package lightning.render.relight;

import static lightning.render.relight.StudioRenderer.assertWork;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.DisplayCurve;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.ReferenceRows;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.Geometry;
import lightning.render.trace.SurfacePoint;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureWrap;
import lightning.scene.light.LightType;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Coat;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.Sheen;
import lightning.scene.material.SurfaceMaps;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests that each edit of a material does the least work: no visibility pass, and rays only from rows that start to mirror. */
class MaterialWorkTest {
    private static final String MATT = "matt";
    private static final String GLASS = "glass";
    private static final Optional<TextureMap> CHECKS = Optional.of(new TextureMap("c.png", 3, 2,
            new Texture(2, 2, new float[] {1, 0.5f, 0, 0, 0.25f, 1, 0.1f, 0.2f, 0.3f, 1, 1, 1})));

    private static StudioRenderer studio(ReflectionMode reflections, MirrorStorage storage) {
        return new StudioRenderer(reflections, storage, StudioScene.of(LightType.SPOT));
    }

    private static Scene edited(Scene scene, String name, UnaryOperator<Material> edit) {
        return scene.withMaterial(edit.apply(scene.material(name).orElseThrow()));
    }

    private static UpdateResult edit(StudioRenderer studio, String name, UnaryOperator<Material> edit) {
        return studio.render(edited(studio.scene(), name, edit));
    }

    private static Predicate<SurfacePoint> ofMaterial(StudioRenderer studio, String material) {
        Geometry geometry = Geometry.of(studio.scene());
        return p -> geometry.materials().material(p.material()).name().equals(material);
    }

    private static long litRows(StudioRenderer studio, String material) {
        ReferenceRows reference = studio.referenceRows();
        long rows = reference.count(0, reference.isLit(studio.key()).and(ofMaterial(studio, material)));
        assertThat(rows).isPositive();
        return rows;
    }

    private static long rows(StudioRenderer studio) {
        return studio.referenceRows().rowsOfLevel(0).size();
    }

    /** Returns the number of rays from all reflective rows within the depth. */
    private static long mirrored(ReferenceRows reference) {
        long rays = 0;
        for (int k = 0; k < 2; k++) {
            rays += reference.count(k, reference::isMirror);
        }
        return rays;
    }

    private static long reached(ReferenceRows reference, StudioRenderer studio) {
        return reference.count(1, reference.isReached(studio.key())) + reference.count(2, reference.isReached(studio.key()));
    }

    private static void assertExact(StudioRenderer studio, String name) {
        FilmAssert.assertSameBits(studio.renderer().film(),
                new ReferenceTracer(studio.scene(), studio.renderer().cache().mirrored().scene()).trace(), name);
    }

    @ParameterizedTest
    @EnumSource(MirrorStorage.class)
    void colors_onlyCompose(MirrorStorage storage) {
        try (StudioRenderer studio = studio(ReflectionMode.STALE, storage)) {
            for (UnaryOperator<Material> edit : List.<UnaryOperator<Material>>of(m -> m.withAmbient(Rgb.WHITE),
                    m -> m.withGlow(new Rgb(0.3, 2, 0)),
                    m -> m.withDiffuse(new Rgb(1, 0, 0.3)), m -> m.withSpecular(Rgb.gray(0.9)), m -> m.withReflective(Rgb.gray(0.1)))) {
                UpdateResult update = edit(studio, GLASS, edit);
                assertThat(update.plan().steps()).containsExactly("glass: colors");
                assertWork(update, 0, rows(studio), 0, 0);
                assertExact(studio, "colors");
            }
        }
    }

    @Test
    void colors_composeAllLevelsWithCurrentReflections() {
        try (StudioRenderer studio = studio(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS)) {
            assertWork(edit(studio, GLASS, m -> m.withReflective(Rgb.gray(0.1))), 0, studio.referenceRows().rowsFrom(0), 0, 0);
            assertExact(studio, "colors");
        }
    }

    @Test
    void shininess_rewritesSpecularOfLitRows() {
        try (StudioRenderer studio = studio(ReflectionMode.STALE, MirrorStorage.FULL_ROWS)) {
            UpdateResult update = edit(studio, MATT, m -> m.withShininess(30.5));
            assertThat(update.plan().steps()).containsExactly("matt: specular term");
            assertWork(update, litRows(studio, MATT), rows(studio), 0, 0);
            assertExact(studio, "shininess");
        }
    }

    @Test
    void highlights_addAndRemoveColumn() {
        try (StudioRenderer studio = studio(ReflectionMode.STALE, MirrorStorage.FULL_ROWS)) {
            long before = studio.renderer().cache().bytes();
            assertWork(edit(studio, MATT, m -> m.withSpecular(Rgb.BLACK)), 0, rows(studio), 0, 0);
            assertWork(edit(studio, GLASS, m -> m.withSpecular(Rgb.BLACK)), 0, rows(studio), 0, 0);
            assertThat(before - studio.renderer().cache().bytes()).as("bytes of the first level's column")
                    .isEqualTo(4 * (rows(studio) + 15 & ~15));
            UpdateResult update = edit(studio, GLASS, m -> m.withSpecular(new Rgb(0, 0, 0.5)));
            assertWork(update, litRows(studio, GLASS), rows(studio), 0, 0);
            assertThat(studio.renderer().cache().bytes()).isEqualTo(before);
            assertExact(studio, "highlights");
        }
    }

    @Test
    void shininessWithoutHighlights_doesNothing() {
        try (StudioRenderer studio = studio(ReflectionMode.STALE, MirrorStorage.FULL_ROWS)) {
            edit(studio, MATT, m -> m.withSpecular(Rgb.BLACK));
            assertWork(edit(studio, MATT, m -> m.withShininess(50)), 0, 0, 0, 0);
            edit(studio, MATT, m -> m.withSpecular(Rgb.WHITE));
            assertExact(studio, "shininess-meanwhile");
        }
    }

    @Test
    void shininessWhileLightOff_castsNoRaysWhenSwitchedOn() {
        try (StudioRenderer studio = studio(ReflectionMode.STALE, MirrorStorage.FULL_ROWS)) {
            studio.edit(l -> l.withOn(false));
            edit(studio, MATT, m -> m.withShininess(2));
            assertWork(studio.edit(l -> l.withOn(true)), 0, rows(studio), 0, 0);
            assertExact(studio, "shininess-in-the-dark");
        }
    }

    @Test
    void texture_updatesTexelsOfItsRows() {
        try (StudioRenderer studio = studio(ReflectionMode.STALE, MirrorStorage.FULL_ROWS).withOutdatedMirrors()) {
            long before = studio.renderer().cache().bytes();
            for (Optional<TextureMap> texture : List.of(CHECKS, CHECKS.map(t -> new TextureMap("d.png", -1, 7, t.image())),
                    CHECKS.map(t -> t.withWrap(TextureWrap.CLAMP)))) {
                UpdateResult update = edit(studio, MATT, m -> m.withTexture(texture));
                assertThat(update.plan().steps()).containsExactly("matt: texture");
                assertWork(update, studio.referenceRows().count(0, ofMaterial(studio, MATT)), rows(studio), 0, 0);
                assertExact(studio, "texture");
            }
            assertThat(studio.renderer().cache().bytes()).isGreaterThan(before);
            assertWork(edit(studio, MATT, m -> m.withTexture(Optional.empty())), 0, rows(studio), 0, 0);
            assertThat(studio.renderer().cache().bytes()).isEqualTo(before);
            assertExact(studio, "no-texture");
        }
    }

    private static StudioRenderer principledStudio() {
        Scene scene = StudioScene.of(LightType.SPOT);
        return new StudioRenderer(ReflectionMode.STALE, MirrorStorage.FULL_ROWS,
                edited(scene, MATT, m -> m.withModel(ShadingModel.PRINCIPLED)));
    }

    @Test
    void roughnessMap_updatesTexelsAndSpecularOfItsRows() {
        try (StudioRenderer studio = principledStudio()) {
            for (UnaryOperator<SurfaceMaps> edit : List.<UnaryOperator<SurfaceMaps>>of(maps -> maps.withRoughness(CHECKS),
                    maps -> maps.withRoughnessChannel(TextureChannel.RED),
                    maps -> maps.withRoughness(CHECKS.map(map -> map.withRepeatU(-2))))) {
                UpdateResult update = edit(studio, MATT, m -> m.withSurfaceMaps(edit.apply(m.surfaceMaps())));
                assertThat(update.plan().steps()).contains("matt: texture + specular term");
                assertThat(update.rays().shadow()).as("of surfels only").isLessThan(studio.referenceRows().count(0, _ -> true));
                assertExact(studio, "roughness-map");
            }
            edit(studio, MATT, m -> m.withSurfaceMaps(SurfaceMaps.NONE));
            assertExact(studio, "no-map");
        }
    }

    @Test
    void roughnessMapWhileLightOff_castsNoReflectedRayWhenSwitchedOn() {
        try (StudioRenderer studio = principledStudio()) {
            studio.edit(l -> l.withOn(false));
            edit(studio, MATT, m -> m.withSurfaceMaps(SurfaceMaps.NONE.withRoughness(CHECKS)));
            // Surfels of other paths are lit when the light is on.
            assertThat(studio.edit(l -> l.withOn(true)).rays().gather()).isZero();
            assertExact(studio, "roughness-map-in-the-dark");
        }
    }

    @Test
    void metalnessMap_updatesTexelsOfItsRows() {
        try (StudioRenderer studio = principledStudio()) {
            edit(studio, MATT, m -> m.withMetalness(0.5));
            for (UnaryOperator<SurfaceMaps> edit : List.<UnaryOperator<SurfaceMaps>>of(maps -> maps.withMetalness(CHECKS),
                    maps -> maps.withMetalnessChannel(TextureChannel.RED))) {
                UpdateResult update = edit(studio, MATT, m -> m.withSurfaceMaps(edit.apply(m.surfaceMaps())));
                assertThat(update.plan().steps()).contains("matt: texture");
                assertExact(studio, "metalness-map");
            }
        }
    }

    @Test
    void channelWithoutMap_doesNothing() {
        try (StudioRenderer studio = principledStudio().withOutdatedMirrors()) {
            assertWork(edit(studio, MATT, m -> m.withSurfaceMaps(SurfaceMaps.NONE.withRoughnessChannel(TextureChannel.RED)
                    .withMetalnessChannel(TextureChannel.RED).withF0Channel(TextureChannel.BLUE))), 0, 0, 0, 0);
            assertWork(edit(studio, MATT, m -> m.withLayerMaps(LayerMaps.NONE.withCoatChannel(TextureChannel.BLUE)
                    .withCoatRoughnessChannel(TextureChannel.RED).withSheenRoughnessChannel(TextureChannel.BLUE))), 0, 0, 0, 0);
        }
    }

    /** Without a sheen: with one, the sum of all that the surface below reflects depends on the mean of the map. */
    @Test
    void mapsOfReflectedColors_updateTexelsOfTheirRows() {
        try (StudioRenderer studio = principledStudio()) {
            for (UnaryOperator<Material> edit : List.<UnaryOperator<Material>>of(
                    m -> m.withSurfaceMaps(SurfaceMaps.NONE.withF0(CHECKS)),
                    m -> m.withSurfaceMaps(m.surfaceMaps().withSpecularTint(CHECKS)))) {
                assertThat(edit(studio, MATT, edit).plan().steps()).contains("matt: texture");
                assertExact(studio, "reflected-colors");
            }
        }
    }

    @Test
    void sheenMap_updatesTexelsOfItsRows() {
        try (StudioRenderer studio = principledStudio()) {
            edit(studio, MATT, m -> m.withSheen(new Sheen(Rgb.WHITE, 0.5)));
            assertThat(edit(studio, MATT, m -> m.withLayerMaps(LayerMaps.NONE.withSheen(CHECKS))).plan().steps())
                    .contains("matt: texture");
            assertExact(studio, "sheen-map");
        }
    }

    /** A smooth coat mirrors along its normals, so an edit of them, and of what mirrors, traces rays again. */
    @Test
    void editsOfCoatNormals_areExact() {
        try (StudioRenderer studio = principledStudio()) {
            edit(studio, MATT, m -> m.withBumpMapping(BumpMapping.NONE.withNormalMap(CHECKS)));
            for (UnaryOperator<Material> edit : List.<UnaryOperator<Material>>of(m -> m.withCoat(new Coat(1, 0, 1.5)),
                    m -> m.withLayerMaps(LayerMaps.NONE.withCoatNormal(CHECKS).withCoatStrength(0.5)), m -> m.withRoughness(0),
                    m -> m.withRoughness(0.5), m -> m.withCoat(new Coat(1, 0.5, 1.5)), m -> m.withBumpMapping(BumpMapping.NONE),
                    m -> m.withCoat(Coat.NONE))) {
                edit(studio, MATT, edit);
                assertExact(studio, "coat-normals");
            }
        }
    }

    @Test
    void mapsOfHighlights_updateTexelsAndSpecularOfTheirRows() {
        try (StudioRenderer studio = principledStudio()) {
            edit(studio, MATT, m -> m.withCoat(new Coat(1, 0.5, 1.5)).withSheen(new Sheen(Rgb.WHITE, 0.5)));
            for (UnaryOperator<LayerMaps> edit : List.<UnaryOperator<LayerMaps>>of(maps -> maps.withCoat(CHECKS),
                    maps -> maps.withCoatRoughness(CHECKS), maps -> maps.withCoatChannel(TextureChannel.BLUE),
                    maps -> maps.withSheenRoughness(CHECKS))) {
                UpdateResult update = edit(studio, MATT, m -> m.withLayerMaps(edit.apply(m.layerMaps())));
                assertThat(update.plan().steps()).contains("matt: texture + specular term");
                assertThat(update.rays().shadow()).as("of surfels only").isLessThan(studio.referenceRows().count(0, _ -> true));
                assertExact(studio, "layer-map");
            }
        }
    }

    @Test
    void renamedTexture_doesNothing() {
        try (StudioRenderer studio = studio(ReflectionMode.STALE, MirrorStorage.FULL_ROWS)) {
            edit(studio, MATT, m -> m.withTexture(CHECKS));
            Texture copy = new Texture(2, 2, new float[] {1, 0.5f, 0, 0, 0.25f, 1, 0.1f, 0.2f, 0.3f, 1, 1, 1});
            assertWork(edit(studio, MATT, m -> m.withTexture(Optional.of(new TextureMap("other.png", 3, 2, copy)))), 0, 0, 0, 0);
        }
    }

    @Test
    void newMirrorMaterial_castsOnlyNewMirrorRays() {
        try (StudioRenderer studio = studio(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS)) {
            ReferenceRows before = studio.referenceRows();
            UpdateResult update = edit(studio, MATT, m -> m.withReflective(new Rgb(0, 0.3, 0)));
            ReferenceRows reference = studio.referenceRows();
            assertThat(update.plan().steps()).containsExactly("matt: begins to mirror", "reflections");
            long newRows = reference.rowsFrom(1) - before.rowsFrom(1);
            assertThat(newRows).isPositive();
            assertWork(update, newRows, reference.rowsFrom(0), mirrored(reference) - mirrored(before),
                    reached(reference, studio) - reached(before, studio));
            assertExact(studio, "begins-to-mirror");
        }
    }

    @ParameterizedTest
    @EnumSource(ReflectionMode.class)
    void removedMirrorMaterial_castsNothingAndFreesLevels(ReflectionMode reflections) {
        try (StudioRenderer studio = studio(reflections, MirrorStorage.FULL_ROWS)) {
            UpdateResult update = edit(studio, GLASS, m -> m.withReflective(Rgb.BLACK));
            assertThat(update.plan().steps().getFirst()).isEqualTo("glass: ceases to mirror");
            assertWork(update, 0, rows(studio), 0, 0);
            assertThat(studio.renderer().cache().rowCount()).isEqualTo(rows(studio));
            assertExact(studio, "ceases-to-mirror");
        }
    }

    /** Further bounces show the older scene: in the sphere's new mirror image, the sphere itself does not mirror. */
    @ParameterizedTest
    @EnumSource(MirrorStorage.class)
    void staleReflections_showOlderSceneInNewMirror(MirrorStorage storage) {
        try (StudioRenderer studio = studio(ReflectionMode.STALE, storage)) {
            Scene mirrored = studio.scene();
            edit(studio, GLASS, m -> m.withDiffuse(new Rgb(1, 0, 0)));
            studio.edit(l -> l.withColor(new Rgb(0, 1, 0)));
            UpdateResult update = edit(studio, MATT, m -> m.withReflective(Rgb.gray(0.9)));
            assertThat(update.rays().eye()).isZero();
            assertThat(update.rays().mirrored()).isPositive();
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene(), mirrored).trace(), "stale-mirror");
            studio.renderer().updateReflections(Progress.NONE);
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "updated-mirror");
        }
    }

    @Test
    void mirrorsStoredAsHitShapes_areRetracedForNewMirror() {
        try (StudioRenderer studio = studio(ReflectionMode.CURRENT, MirrorStorage.HIT_SHAPES)) {
            UpdateResult update = edit(studio, MATT, m -> m.withReflective(Rgb.gray(0.3)));
            ReferenceRows reference = studio.referenceRows();
            assertWork(update, reference.rowsFrom(1), reference.rowsFrom(0), mirrored(reference), reached(reference, studio));
            assertExact(studio, "begins-to-mirror");
        }
    }

    /** At accuracy ratio samples stay until a refresh; by then mirrors differ from those at their selection. */
    @ParameterizedTest
    @EnumSource(MirrorStorage.class)
    void toggledMirrors_areSampledOnRefresh(MirrorStorage storage) {
        Scene scene = StudioScene.of(LightType.SPOT);
        scene = scene.withPicture(scene.picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 2)));
        try (Renderer renderer = new Renderer(new RenderOptions(Accuracy.RATIO, ReflectionMode.STALE, storage, 1))) {
            renderer.render(scene, Progress.NONE);
            scene = edited(edited(scene, MATT, m -> m.withReflective(Rgb.gray(0.9)).withTexture(CHECKS)), GLASS,
                    m -> m.withReflective(Rgb.BLACK));
            renderer.render(scene, Progress.NONE);
            renderer.setView(160, DisplayCurve.SRGB);
            UpdateResult update = renderer.render(scene.withLight(scene.lights().getFirst().withIntensity(0.7)), Progress.NONE);
            assertThat(update.wasRefreshed()).isTrue();
            assertThat(FilmError.largestError(renderer.film(), ReferenceCheck.referenceFilm(renderer.cache())))
                    .isLessThanOrEqualTo(update.errorBound());
        }
    }

    @Test
    void tilesWithoutMaterial_areUntouched() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Shape ball = new Shape(Solid.SPHERE, "left", MATT, new Placement(new Vec3(-3, 0, 0), Vec3.ZERO, Vec3.ONE));
        Scene wide = new Scene(new PictureSettings(64, 24, 0), scene.camera(), scene.world(), scene.materials(),
                List.of(scene.nodes().getFirst(), ball), scene.lights());
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.STALE, MirrorStorage.FULL_ROWS, wide)) {
            UpdateResult update = edit(studio, MATT, m -> m.withDiffuse(Rgb.WHITE));
            assertWork(update, 0, studio.referenceRows().count(0, p -> p.vx() < 0), 0, 0);
            assertExact(studio, "one-tile");
        }
    }

    @Test
    void unusedMaterials_areNoEdit() {
        try (StudioRenderer studio = studio(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS)) {
            List<Material> more =
                    List.of(studio.scene().materials().getLast(), Material.of("spare").withAmbient(Rgb.WHITE).withDiffuse(Rgb.WHITE)
                            .withSpecular(Rgb.WHITE).withShininess(1).withReflective(Rgb.WHITE), studio.scene().materials().getFirst());
            assertWork(studio.render(studio.scene().withMaterials(more)), 0, 0, 0, 0);
            assertWork(studio.render(studio.scene().withMaterials(more.reversed())), 0, 0, 0, 0);
        }
    }

    @Test
    void materialAndLightEdit_costsSumOfBoth() {
        try (StudioRenderer studio = studio(ReflectionMode.STALE, MirrorStorage.FULL_ROWS)) {
            Scene scene =
                    edited(edited(studio.scene(), MATT, m -> m.withShininess(3).withTexture(CHECKS)), GLASS, m -> m.withDiffuse(Rgb.WHITE));
            long matte = studio.referenceRows().count(0, ofMaterial(studio, MATT));
            long lit = litRows(studio, MATT);
            UpdateResult update = studio.render(scene.withLight(studio.key().withIntensity(2)));
            assertThat(update.plan().steps()).containsExactly("key: weight", "glass: colors", "matt: texture + specular term");
            assertWork(update, matte + lit, rows(studio), 0, 0);
            assertExact(studio, "composite");
        }
    }
}
