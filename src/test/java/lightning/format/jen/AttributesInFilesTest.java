package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Optional;
import lightning.sample.AttributeArbitraries;
import lightning.sample.AttributeArbitraries.Changed;
import lightning.sample.StudioScene;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.Scene;
import lightning.scene.ValueKind;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Every attribute of the tables can be written, read, saved into a file that was there, and set by name. */
class AttributesInFilesTest {
    private static final String MATT = "matt";
    private final Scene studio = StudioScene.of(LightType.SPOT);

    @Provide
    Arbitrary<Changed<Light>> lights() {
        return AttributeArbitraries.lights().map(l -> new Changed<>(l.attribute(), plain(l.before()), plain(l.after())));
    }

    /** Pictures on surfaces need a file: {@link TextureTest} has them. */
    @Provide
    Arbitrary<Changed<Material>> materials() {
        return AttributeArbitraries.materials(MATT).filter(m -> !(m.attribute().kind() instanceof ValueKind.Texturing))
                .map(m -> new Changed<>(m.attribute(), plain(m.before()), plain(m.after())));
    }

    /** Without files, and linked to what there is: a file that names anything else is refused. */
    private Light plain(Light light) {
        return light.withGobo(Optional.empty()).withProfile(Optional.empty())
                .withIlluminates(light.illuminates().within(studio.stage()::hasNode))
                .withShadowedBy(light.shadowedBy().within(studio.stage()::hasNode));
    }

    private static Material plain(Material material) {
        return material.withTexture(Optional.empty())
                .withRelief(material.relief().withBump(Optional.empty()).withNormals(Optional.empty()))
                .withCutout(material.cutout().withCutout(Optional.empty()));
    }

    @Property
    void light_isWrittenReadSavedAndSetByName(@ForAll("lights") Changed<Light> changed) throws JenException {
        assertInFiles(studio.withLight(changed.before()), studio.withLight(changed.after()), StudioScene.KEY,
                changed.attribute().name(), Blocks.LIGHT.values(changed.after()).get(changed.attribute().name()));
    }

    @Property
    void material_isWrittenReadSavedAndSetByName(@ForAll("materials") Changed<Material> changed) throws JenException {
        Optional<String> obstacle = ((MaterialAttribute<?>) changed.attribute()).obstacle(changed.before().model());
        if (obstacle.isPresent()) {
            assertThat(changed.after()).isEqualTo(changed.before());
            assertThatThrownBy(() -> PropertyEdit.set(studio.withMaterial(changed.before()), "material:" + MATT,
                    changed.attribute().name(), "1")).hasMessage("material 'matt': " + obstacle.get());
            return;
        }
        assertInFiles(studio.withMaterial(changed.before()), studio.withMaterial(changed.after()), "material:" + MATT,
                changed.attribute().name(), Blocks.MATERIAL.values(changed.after()).get(changed.attribute().name()));
    }

    private static void assertInFiles(Scene before, Scene after, String target, String property, Value value) throws JenException {
        JenDocument document = JenReader.read(JenWriter.write(before), "before.jen", Path.of(""));
        assertThat(document.scene()).isEqualTo(before);
        JenDocument saved = JenReader.read(document.with(after).text(), "after.jen", Path.of(""));
        assertThat(saved.scene()).isEqualTo(after);
        assertThat(PropertyEdit.set(before, target, property, value instanceof Value.Absent ? "none" : value.text())).isEqualTo(after);
    }
}
