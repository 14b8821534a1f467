package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.cache.TileLevel;
import lightning.render.image.Film;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Beam;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.Photometry;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests the work of area light edits and that they are exact. */
class AreaLightWorkTest {
    private static final int SAMPLES = 8;
    private static final Texture RED_AND_GREEN = new Texture(2, 1, new float[] {1, 0, 0, 0, 1, 0});

    private static Light areaLight(Light light) {
        return light.withArea(new AreaShape(0.4, 5, 0.7, 0.5, Vec3.Y, SAMPLES));
    }

    private static StudioRenderer studio(LightType type) {
        StudioRenderer studio = StudioRenderer.of(type);
        studio.edit(AreaLightWorkTest::areaLight);
        return studio;
    }

    private static UpdateResult edit(StudioRenderer studio, UnaryOperator<Light> edit) {
        UpdateResult update = studio.edit(edit);
        studio.renderer().updateReflections(Progress.NONE);
        assertThat(studio.renderer().film().hasSameBits(new ReferenceTracer(studio.scene()).trace())).isTrue();
        return update;
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void colorIntensityAndSwitches_castNoRays(LightType type) {
        try (StudioRenderer studio = studio(type)) {
            for (UnaryOperator<Light> edit : List.<UnaryOperator<Light>>of(l -> l.withColor(new Rgb(1, 0, 0.5)), l -> l.withIntensity(0.3),
                    l -> l.withOn(false), l -> l.withOn(true), l -> l.withSolo(true))) {
                assertThat(edit(studio, edit).rays().shadow()).isZero();
            }
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"RECT", "DISC"})
    void shapeOfTheBeam_castsNoRays(LightType type) {
        var gobo = Optional.of(new Gobo("gobo.png", RED_AND_GREEN));
        var profile = Optional.of(new IesProfile("p.ies",
                new Photometry(Photometry.Type.C, new double[] {0, 30, 90}, new double[] {0, 90}, new double[] {3, 2, 1, 3, 1, 0})));
        try (StudioRenderer studio = studio(type)) {
            for (UnaryOperator<Light> edit : List.<UnaryOperator<Light>>of(l -> l.withBeam(Beam.OPEN.withCone(20)),
                    l -> l.withBeam(l.beam().withSoftness(0.6)), l -> l.withBeam(l.beam().withCone(70)),
                    l -> l.withBeam(l.beam().withSpread(30)), l -> l.withGobo(gobo), l -> l.withBeam(l.beam().withCone(40)),
                    l -> l.withProfile(profile), l -> l.withDropoff(2), l -> l.withBeam(Beam.OPEN), l -> l.withGobo(Optional.empty()))) {
                UpdateResult update = edit(studio, edit);
                assertThat(update.rays().shadow()).isZero();
                assertThat(update.rays().eye()).isZero();
            }
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void attenuationDropoffDoorsAndSmallerAngle_castNoRays(LightType type) {
        try (StudioRenderer studio = studio(type)) {
            for (UnaryOperator<Light> edit : List.<UnaryOperator<Light>>of(l -> l.withAttenuation(new Attenuation(0, 1, 1)),
                    l -> l.withDropoff(7), l -> l.withDoors(new BarnDoors(5, 20, 90, 8)), l -> l.withFeather(4),
                    l -> l.withAngle(l.angle() * 0.7))) {
                assertThat(edit(studio, edit).rays().shadow()).isZero();
            }
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"RECT", "DISC"})
    void texture_castsNoRays(LightType type) {
        try (StudioRenderer studio = studio(type)) {
            edit(studio, l -> l.withIntensity(0.9));
            long bytes = studio.renderer().cache().bytes();
            Film plain = new ReferenceTracer(studio.scene()).trace();
            for (Texture image : List.of(RED_AND_GREEN, new Texture(1, 2, new float[] {4, 3, 2, 0, 0, 0.1f}))) {
                UpdateResult update = edit(studio, l -> l.withTexture(Optional.of(new LightTexture("face.png", image))));
                assertThat(update.rays().shadow()).isZero();
                assertThat(update.rowsTouched()).isPositive();
                assertThat(studio.renderer().film().hasSameBits(plain)).isFalse();
                assertThat(edit(studio, l -> l.withIntensity(l.intensity() * 0.7)).rays().shadow()).isZero();
            }
            assertThat(studio.renderer().cache().bytes()).isGreaterThan(bytes);
            edit(studio, l -> l.withTexture(Optional.empty()));
            assertThat(studio.renderer().cache().bytes()).isEqualTo(bytes);
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void whiteTexture_changesNoBit(LightType type) {
        try (StudioRenderer studio = studio(type)) {
            Film plain = new ReferenceTracer(studio.scene()).trace();
            edit(studio, l -> l.withTexture(Optional.of(new LightTexture("white.png", new Texture(1, 1, new float[] {1, 1, 1})))));
            assertThat(studio.renderer().film().hasSameBits(plain)).isTrue();
        }
    }

    @Test
    void textureOfLightWithoutFace_hasNoEffect() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.RECT)) {
            UpdateResult update = studio.edit(l -> l.withTexture(Optional.of(new LightTexture("face.png", RED_AND_GREEN))));
            assertThat(update.rowsTouched()).isZero();
        }
    }

    @Test
    void shininess_castsNoRays() {
        try (StudioRenderer studio = studio(LightType.RECT)) {
            Scene scene = studio.scene();
            Scene shinier = scene.withMaterials(scene.materials().stream().map(m -> m.withShininess(30)).toList());
            assertThat(studio.render(shinier).rays().shadow()).isZero();
        }
    }

    /** Rows with known shadow rays cast no new ones, even if another sample had them in its cone. */
    @Test
    void restoredCone_castsNoRays() {
        try (StudioRenderer studio = studio(LightType.SPOT)) {
            double angle = studio.key().angle();
            Vec3 direction = studio.key().direction();
            edit(studio, l -> l.withAngle(angle * 0.5));
            assertThat(edit(studio, l -> l.withAngle(angle)).rays().shadow()).isZero();
            edit(studio, l -> l.withDirection(new Vec3(0, -1, 0)));
            assertThat(edit(studio, l -> l.withDirection(direction)).rays().shadow()).isZero();
        }
    }

    @Test
    void largerAngle_castsOnlyForEnteringRows() {
        try (StudioRenderer studio = studio(LightType.SPOT)) {
            UpdateResult wider = edit(studio, l -> l.withAngle(l.angle() * 1.1));
            UpdateResult moved = edit(studio, l -> l.withPosition(l.position().plus(new Vec3(1e-9, 0, 0))));
            assertThat(wider.rays().shadow()).isPositive().isLessThan(moved.rays().shadow());
        }
    }

    /** Floor seen from under a sphere that hides it from the light completely, even after small movements of the light. */
    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void lightMovedBehindSphere_castsNoRaysInFullShadow(LightType type) {
        Light source = areaLight(Light.of("key", type).withPosition(new Vec3(0, 20, 0)).withDirection(new Vec3(0, -1, 0)));
        Scene scene =
                new Scene(new PictureSettings(64, 32, 1), new Camera(new Vec3(0, 2.5, 0), Vec3.ZERO, new Vec3(0, 0, -1), 20), World.DEFAULT,
                        List.of(Material.of("matte").withDiffuse(Rgb.gray(0.7))),
                        List.of(shape(Solid.PLANE, new Vec3(0, 0, 0), 40), shape(Solid.SPHERE, new Vec3(0, 8, 0), 5)), List.of(source));
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene)) {
            UpdateResult moved = edit(studio, l -> l.withPosition(new Vec3(0.3, 20, 0)).withDirection(new Vec3(0.02, -1, 0)));
            assertThat(moved.rowsTouched()).isPositive();
            assertThat(moved.rays().shadow()).isZero();
            UpdateResult edge = edit(studio, l -> l.withPosition(new Vec3(15, 20, 0)).withDirection(new Vec3(-15, -20, 0)));
            assertThat(edge.rays().shadow()).isPositive();
        }
    }

    private static Shape shape(Solid solid, Vec3 at, double size) {
        return new Shape(solid, solid.typeName(), "matte", new Placement(at, Vec3.ZERO, Vec3.ONE.times(size)));
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void lightOfSizeZero_isPointWithoutSamples(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            long bytes = studio.renderer().cache().bytes();
            UpdateResult update = studio.edit(l -> l.withArea(l.area().withSamples(64)));
            assertThat(update.rays().shadow()).isZero();
            assertThat(studio.renderer().cache().bytes()).isEqualTo(bytes);
        }
    }

    /** The floor faces all samples of a light above it. */
    @Test
    void onlyRowsInPenumbra_useFurtherSamples() {
        try (StudioRenderer studio = studio(LightType.POINT)) {
            int plain = 0;
            int refined = 0;
            for (int t = 0; t < studio.renderer().cache().tileCount(); t++) {
                TileLevel level = studio.renderer().cache().tile(t).levels()[0];
                LightLayer layer = level.layers()[0];
                for (int i = 0; i < level.rows().count; i++) {
                    if (level.rows().ny[i] == 1) {
                        int seen = layer.visibleSamples() == null ? 0 : layer.visibleSamples()[0][i] & (1 << SAMPLES) - 1;
                        boolean isPenumbra = seen != 0 && seen != (1 << SAMPLES) - 1;
                        assertThat((layer.states()[i] & LightRows.REFINED) != 0).isEqualTo(isPenumbra);
                        plain += isPenumbra ? 0 : 1;
                        refined += isPenumbra ? 1 : 0;
                    }
                }
            }
            assertThat(plain).isPositive();
            assertThat(refined).isPositive();
        }
    }

    @Test
    void visibleSamples_useTwoBytesPerSixteen() {
        assertThat(LightRows.columns(areaLight(StudioScene.key(LightType.POINT)), false, false))
                .as("8 samples, 32 in a penumbra").contains(LightRows.Column.SEEN_0, LightRows.Column.SEEN_1)
                .doesNotContain(LightRows.Column.SEEN_2, LightRows.Column.FALLOFF);
        Light fine = StudioScene.key(LightType.POINT).withArea(new AreaShape(1, 0, 0, 0, Vec3.Y, 33));
        assertThat(LightRows.columns(fine, false, false)).contains(LightRows.Column.SEEN_2).doesNotContain(LightRows.Column.SEEN_3);
        assertThat(LightRows.columns(StudioScene.key(LightType.POINT), false, false)).containsExactlyInAnyOrder(LightRows.Column.STATE,
                LightRows.Column.COSINE, LightRows.Column.SPECULAR, LightRows.Column.FALLOFF);
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void otherShadowCasters_castRaysOnlyForTheirShadows(LightType type) {
        try (StudioRenderer studio = studio(type)) {
            long all = edit(studio, l -> l.withPosition(l.position().plus(new Vec3(1e-9, 0, 0))).withDirection(
                    l.direction().plus(new Vec3(1e-9, 0, 0)))).rays().shadow();
            assertThat(edit(studio, l -> l.withShadowedBy(ShapeLinks.except("ball"))).rays().shadow()).isBetween(1L, all - 1);
            assertThat(edit(studio, l -> l.withShadowedBy(ShapeLinks.ALL)).rays().shadow()).isBetween(1L, all - 1);
        }
    }

    /** Other samples may be in the cone of any row. */
    @Test
    void falloff_touchesLitRowsAndCone_touchesAll() {
        try (StudioRenderer studio = studio(LightType.SPOT)) {
            long rows = studio.referenceRows().rowsOfLevel(0).size();
            assertThat(studio.edit(l -> l.withAttenuation(new Attenuation(0, 1, 1))).rowsTouched()).isBetween(1L, rows - 1);
            assertThat(studio.edit(l -> l.withAngle(l.angle() * 0.9)).rowsTouched()).isEqualTo(rows);
        }
    }

    @Test
    void shininess_touchesLitRows() {
        try (StudioRenderer studio = studio(LightType.RECT)) {
            long rows = studio.referenceRows().rowsOfLevel(0).size();
            UpdateResult update = studio.render(studio.scene().withMaterials(
                    studio.scene().materials().stream().map(m -> m.withShininess(30)).toList()));
            assertThat(update.rowsTouched()).isBetween(1L, rows - 1);
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void modelOfMaterialUnderImage_changesAllTerms(LightType type) {
        try (StudioRenderer studio = studio(type)) {
            edit(studio, l -> l.withTexture(Optional.of(new LightTexture("face.png", RED_AND_GREEN))));
            Material matt = studio.scene().material("matt").orElseThrow();
            for (Material material : List.of(matt.withModel(ShadingModel.METALLIC).withMetalness(0.5).withRoughness(0.4), matt)) {
                UpdateResult update = studio.render(studio.scene().withMaterial(material));
                assertThat(update.rays().shadow()).isZero();
                studio.renderer().updateReflections(Progress.NONE);
                assertThat(studio.renderer().film().hasSameBits(new ReferenceTracer(studio.scene()).trace())).isTrue();
            }
        }
    }
}
