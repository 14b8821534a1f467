package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.ShadingModel;
import org.junit.jupiter.api.Test;

/** Tests that each edit of a metallic material does the least work and casts no ray. */
class MetallicWorkTest {
    private static final String MATT = "matt";

    private static StudioRenderer studio() {
        Scene plain = StudioScene.of(LightType.SPOT);
        return new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS,
                plain.withMaterial(metal(plain.material(MATT).orElseThrow())));
    }

    private static Material metal(Material material) {
        return material.withModel(ShadingModel.METALLIC).withMetalness(0.5).withRoughness(0.3);
    }

    private static UpdateResult edit(StudioRenderer studio, UnaryOperator<Material> edit) {
        UpdateResult update = studio.render(studio.scene().withMaterial(edit.apply(studio.scene().material(MATT).orElseThrow())));
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "metal");
        assertThat(update.rays().shadow()).isZero();
        assertThat(update.rays().eye()).isZero();
        return update;
    }

    private static long bytes(StudioRenderer studio, LightRows.Column column) {
        return studio.renderer().cache().allTiles().stream().flatMap(tile -> List.of(tile.levels()).stream())
                .flatMap(level -> List.of(level.layers()).stream()).mapToLong(layer -> ((LightRows) layer).bytes(column)).sum();
    }

    @Test
    void baseColorMetalnessAndF0_onlyCompose() {
        try (StudioRenderer studio = studio()) {
            for (UnaryOperator<Material> edit : List.<UnaryOperator<Material>>of(m -> m.withBase(new Rgb(1, 0, 0.3)),
                    m -> m.withMetalness(1), m -> m.withF0(0.2))) {
                UpdateResult update = edit(studio, edit);
                assertThat(update.plan().steps()).contains("matt: colors");
                assertThat(update.rowsTouched()).isZero();
            }
        }
    }

    @Test
    void roughness_recomputesSpecularTerms() {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = edit(studio, m -> m.withRoughness(0.6));
            assertThat(update.plan().steps()).contains("matt: specular term");
            assertThat(update.rowsTouched()).isPositive();
        }
    }

    /** Its rows are reordered before their terms are updated. */
    @Test
    void mirrorChangedToPhong_hasPhongDiffuse() {
        try (StudioRenderer studio = studio()) {
            studio.render(studio.scene().withMaterial(studio.scene().material(MATT).orElseThrow().withReflective(Rgb.gray(0.4))));
            edit(studio, m -> m.withModel(ShadingModel.PHONG).withReflective(Rgb.BLACK));
            assertThat(bytes(studio, LightRows.Column.GRAZING)).isZero();
        }
    }

    @Test
    void grazingColumn_existsOnlyWithMetallicMaterial() {
        try (StudioRenderer studio = studio()) {
            assertThat(bytes(studio, LightRows.Column.GRAZING)).isPositive().isLessThanOrEqualTo(bytes(studio, LightRows.Column.SPECULAR));
            edit(studio, m -> m.withModel(ShadingModel.PHONG));
            assertThat(bytes(studio, LightRows.Column.GRAZING)).isZero();
            edit(studio, MetallicWorkTest::metal);
            assertThat(bytes(studio, LightRows.Column.GRAZING)).isPositive();
        }
    }

    @Test
    void metalChangedToPhongWithoutHighlights_hasPhongDiffuse() {
        try (StudioRenderer studio = studio()) {
            studio.render(studio.scene().withMaterials(studio.scene().materials().stream()
                    .map(m -> m.name().equals(MATT) ? m : m.withSpecular(Rgb.BLACK)).toList()));
            edit(studio, m -> m.withModel(ShadingModel.PHONG).withSpecular(Rgb.BLACK));
            assertThat(bytes(studio, LightRows.Column.GRAZING) + bytes(studio, LightRows.Column.SPECULAR)).isZero();
        }
    }

    /** Shininess and roughness keep their initial values. */
    @Test
    void modelAlone_changesTerms() {
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, StudioScene.of(LightType.SPOT))) {
            edit(studio, m -> m.withSpecular(Rgb.gray(0.4)).withShininess(MaterialAttribute.SHININESS.initial()));
            edit(studio, m -> m.withModel(ShadingModel.METALLIC));
            edit(studio, m -> m.withModel(ShadingModel.PHONG).withSpecular(Rgb.gray(0.4)));
        }
    }
}
