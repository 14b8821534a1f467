package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Optional;
import lightning.sample.AttributeArbitraries;
import lightning.sample.AttributeArbitraries.Changed;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.asset.TextureMap;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Round trip of every attribute: writing, reading, saving into an existing file, and setting by name. */
class AttributeRoundTripTest {
    private static final String MATT = "matt";
    private final Scene studio = StudioScene.of(LightType.SPOT);

    @Provide
    Arbitrary<Changed<Light>> lights() {
        return AttributeArbitraries.lights().map(l -> new Changed<>(l.attribute(), withoutFiles(l.before()), withoutFiles(l.after())));
    }

    /** Materials without textures; {@link TextureLoadingTest} covers those. */
    @Provide
    Arbitrary<Changed<Material>> materials() {
        return AttributeArbitraries.materials(MATT).filter(m -> !(m.attribute().kind() instanceof ValueKind.TextureKind))
                .map(m -> new Changed<>(m.attribute(), withoutFiles(m.before()), withoutFiles(m.after())));
    }

    /** Returns the light without files, and with links to existing objects only, since others are rejected. */
    private Light withoutFiles(Light light) {
        return light.withGobo(Optional.empty()).withProfile(Optional.empty()).withTexture(Optional.empty())
                .retainLinks(studio.stage()::hasNode);
    }

    private static Material withoutFiles(Material material) {
        Material result = material;
        for (MaterialAttribute<Optional<TextureMap>> map : MaterialAttribute.MAPS) {
            result = map.with(result, Optional.empty());
        }
        return result;
    }

    @Property
    void light_roundTripsThroughFilesAndEdits(@ForAll("lights") Changed<Light> changed) throws JenException {
        assertRoundTrip(studio.withLight(changed.before()), studio.withLight(changed.after()), StudioScene.KEY,
                changed.attribute().name(), BlockTypes.LIGHT.values(changed.after()).get(changed.attribute().name()));
    }

    @Property
    void material_roundTripsThroughFilesAndEdits(@ForAll("materials") Changed<Material> changed) throws JenException {
        Optional<String> obstacle = ((MaterialAttribute<?>) changed.attribute()).inactiveReason(changed.before().model());
        if (obstacle.isPresent()) {
            assertThat(changed.after()).isEqualTo(changed.before());
            assertThatThrownBy(() -> PropertyEdit.set(studio.withMaterial(changed.before()), "material:" + MATT,
                    changed.attribute().name(), "1")).hasMessage("material 'matt': " + obstacle.get());
            return;
        }
        assertRoundTrip(studio.withMaterial(changed.before()), studio.withMaterial(changed.after()), "material:" + MATT,
                changed.attribute().name(), BlockTypes.MATERIAL.values(changed.after()).get(changed.attribute().name()));
    }

    private static void assertRoundTrip(Scene before, Scene after, String target, String property, Value value) throws JenException {
        JenDocument document = JenReader.read(JenWriter.write(before), "before.jen", Path.of(""));
        assertThat(document.scene()).isEqualTo(before);
        JenDocument saved = JenReader.read(document.withScene(after).text(), "after.jen", Path.of(""));
        assertThat(saved.scene()).isEqualTo(after);
        assertThat(PropertyEdit.set(before, target, property, value instanceof Value.Absent ? "none" : value.text())).isEqualTo(after);
    }
}
