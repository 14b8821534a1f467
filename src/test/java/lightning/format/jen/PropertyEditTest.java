package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.Shape;
import lightning.scene.value.Attenuation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PropertyEditTest {
    private final Scene scene = read("""
            jen 1
            material floor {}
            group g { sphere ball { material floor } }
            light key spot {}
            light fill point {}
            """);
    private final Light key = scene.light("key").orElseThrow();

    @Test
    void lightGroups_areAddedEditedRenamedAndDeleted() {
        Scene grouped = PropertyEdit.set(PropertyEdit.add(scene, "bank left { intensity 0.5 }"), "key", "bank", "left");
        assertThat(grouped.rig().lightGroups()).containsExactly(LightGroup.of("left").withIntensity(0.5));
        assertThat(grouped.light("key").orElseThrow()).isEqualTo(key.withLightGroup("left"));
        assertThat(PropertyEdit.apply(grouped, "left.on=no").rig().lightGroup("left").orElseThrow().on()).isFalse();
        Scene renamed = PropertyEdit.apply(grouped, "left.name=right");
        assertThat(renamed.light("key").orElseThrow().lightGroup()).isEqualTo("right");
        assertThat(PropertyEdit.add(grouped, "rim spot bank=left").lights().getLast().lightGroup()).isEqualTo("left");
        assertThat(PropertyEdit.delete(grouped, "left")).isEqualTo(scene);
        assertThat(PropertyEdit.apply(grouped, "key.bank=none")).isEqualTo(PropertyEdit.add(scene, "bank left { intensity 0.5 }"));
        assertThatThrownBy(() -> PropertyEdit.apply(grouped, "key.bank=lefd")).hasMessageContaining("there is no light group 'lefd'");
    }

    @Test
    void everyLightProperty_canBeSet() {
        assertThat(key("intensity=0.4")).isEqualTo(key.withIntensity(0.4));
        assertThat(key("color=1 0.9 0.8")).isEqualTo(key.withColor(new Rgb(1, 0.9, 0.8)));
        assertThat(key("at=1 2 -3")).isEqualTo(key.withPosition(new Vec3(1, 2, -3)));
        assertThat(key("direction=1 0 0")).isEqualTo(key.withDirection(new Vec3(1, 0, 0)));
        assertThat(key("attenuation=0.1 1 0.1")).isEqualTo(key.withAttenuation(new Attenuation(0.1, 1, 0.1)));
        assertThat(key("angle=12")).isEqualTo(key.withAngle(12));
        assertThat(key("dropoff=3")).isEqualTo(key.withDropoff(3));
        assertThat(key("type=point")).isEqualTo(key.withType(LightType.POINT));
        assertThat(key("on=no")).isEqualTo(key.withOn(false));
        assertThat(key("solo = yes")).isEqualTo(key.withSolo(true));
    }

    @Test
    void name_renamesTheLightInPlace() {
        assertThat(PropertyEdit.apply(scene, "key.name=rim").lights()).containsExactly(key.withName("rim"), scene.lights().get(1));
    }

    @Test
    void pictureCameraAndWorld_canBeSet() {
        assertThat(PropertyEdit.apply(scene, "picture.size=640 480").picture())
                .isEqualTo(PictureSettings.DEFAULT.withSize(640, 480));
        assertThat(PropertyEdit.apply(scene, "picture.depth=5").picture()).isEqualTo(PictureSettings.DEFAULT.withDepth(5));
        assertThat(PropertyEdit.apply(scene, "camera.from=1 2 3").camera().from()).isEqualTo(new Vec3(1, 2, 3));
        assertThat(PropertyEdit.apply(scene, "world.ambience=0.1").world().ambience()).isEqualTo(0.1);
    }

    @Test
    void groupedShapesAndMaterials_canBeSet() {
        NodeGroup g = (NodeGroup) PropertyEdit.apply(scene, "ball.at=1 2 3").nodes().getFirst();
        assertThat(((Shape) g.children().getFirst()).placement().position()).isEqualTo(new Vec3(1, 2, 3));
        assertThat(PropertyEdit.apply(scene, "g.scale=1 2 1").nodes().getFirst().placement().scale()).isEqualTo(new Vec3(1, 2, 1));
        assertThat(PropertyEdit.apply(scene, "g.visible=no").placedShapes()).isEmpty();
        assertThat(PropertyEdit.apply(scene, "ball.visible=no").stage().node("ball").orElseThrow().visible()).isFalse();
        assertThat(PropertyEdit.apply(scene, "floor.shininess=7").materials().getFirst().shininess()).isEqualTo(7);
    }

    @Test
    void everyMaterialProperty_canBeSet() {
        Material floor = scene.materials().getFirst();
        assertThat(floor("ambient=1 2 3")).isEqualTo(floor.withAmbient(new Rgb(1, 2, 3)));
        assertThat(floor("glow=3 2 1")).isEqualTo(floor.withGlow(new Rgb(3, 2, 1)));
        assertThat(floor("diffuse=1 0.5 0")).isEqualTo(floor.withDiffuse(new Rgb(1, 0.5, 0)));
        assertThat(floor("specular=0.1 0.2 0.3")).isEqualTo(floor.withSpecular(new Rgb(0.1, 0.2, 0.3)));
        assertThat(floor("shininess=30")).isEqualTo(floor.withShininess(30));
        assertThat(floor("reflective=0.5 0.5 0.5")).isEqualTo(floor.withReflective(Rgb.gray(0.5)));
    }

    @Test
    void prefix_selectsTheMaterialOverALight() {
        Scene twins = scene.withLights(List.of(key.withName("floor")));
        assertThat(PropertyEdit.apply(twins, "material:floor.shininess=7").materials().getFirst().shininess()).isEqualTo(7);
        assertThat(PropertyEdit.apply(twins, "floor.intensity=7").lights().getFirst().intensity()).isEqualTo(7);
    }

    @Test
    void textures_areSetRepeatedAndRemoved() {
        Scene wood = PropertyEdit.apply(scene, "material:floor.texture=\"wood.png\"", Path.of("scenes"));
        assertThat(wood.materials().getFirst().texture().orElseThrow().file()).isEqualTo("wood.png");
        Scene repeated = PropertyEdit.apply(wood, "material:floor.repeat=2 -3");
        assertThat(repeated.materials().getFirst().texture().orElseThrow().repeatV()).isEqualTo(-3);
        // Assets already in the scene need no folder.
        assertThat(PropertyEdit.apply(repeated, "material:floor.texture=\"wood.png\"")).isEqualTo(repeated);
        assertThat(PropertyEdit.apply(repeated, "material:floor.texture=none")).isEqualTo(scene);
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "material:floor.texture=\"wod.png\"", Path.of("scenes")))
                .hasMessage("material 'floor': there is no texture 'wod.png' in the folder 'scenes' or the folder 'textures'");
    }

    @Test
    void editedDefaultMaterial_isWritten() {
        Scene edited = PropertyEdit.apply(scene, "material:default.diffuse=1 0 0");
        assertThat(edited.materials()).endsWith(Material.DEFAULT.withDiffuse(new Rgb(1, 0, 0)));
        assertThat(JenDocument.of(scene).withScene(edited).text()).contains("material default { diffuse 1 0 0 }");
    }

    @Test
    void light_isAddedFromBothForms() {
        Light rim = Light.of("rim", LightType.POINT).withIntensity(0.5).withPosition(new Vec3(0, 1, 2));
        assertThat(PropertyEdit.add(scene, "rim point intensity=0.5 at=0 1 2").lights()).endsWith(rim).hasSize(3);
        assertThat(PropertyEdit.add(scene, "light rim point { intensity 0.5 at 0 1 2 }").lights()).endsWith(rim).hasSize(3);
        assertThat(PropertyEdit.add(scene, "rim spot").lights()).endsWith(Light.of("rim", LightType.SPOT));
    }

    @Test
    void light_isDeletedByName() {
        assertThat(PropertyEdit.delete(scene, "key").lights()).extracting(Light::name).containsExactly("fill");
        assertThatThrownBy(() -> PropertyEdit.delete(scene, "fil")).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("there is no light 'fil', did you mean 'fill'?");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "key | an edit must be written as NAME.PROPERTY=VALUE, was 'key'",
        "=1 | an edit must be written as NAME.PROPERTY=VALUE, was '=1'",
        "kee.on=no | the scene has nothing named 'kee', did you mean 'key'?",
        "key.intensty=1 | light 'key': unknown property 'intensty', expected one of color, intensity, exposure, unit, temperature, at, direction, falloff, attenuation, angle, dropoff, cone, cone_softness, beam_spread, doors, feather, gobo, profile, radius, spread, width, height, up, texture, shape, samples, visible, on, solo, bank, illuminates, shadowed_by, casts_shadows, diffuse, specular, fog, gains, flag, flag_at, flag_rotate, flag_width, flag_height, flag_softness, flag_density, filter, filter_at, filter_rotate, filter_size, filter_softness, filter_density, filter_invert, type, name, did you mean 'intensity'?",
        "key.intensity=-3 | light 'key': intensity must be ≥ 0, was -3",
        "key.intensity= | light 'key': intensity must have a number, found 0",
        "key.intensity=1 2 | light 'key': intensity must have a number, found 2",
        "key.intensity=1 on no | light 'key': expected nothing after the value of intensity, found 'on'",
        "key.intensity=1e999 | light 'key': intensity must be a number within ±1.8e308, found '1e999'",
        "key.type=pint | light 'key': type must be directional, point, spot, rect, disc, tube or object, was 'pint', did you mean 'point'?",
        "key.name=fill | light 'fill': the name is already taken",
        "key.name=\"\" | a name must have 1 to 100 characters, no control characters and no spaces at its ends, was ''",
        "key.name= | a name must have 1 to 100 characters, no control characters and no spaces at its ends, was ''",
        "key.name=a\u001Bb | a name must have 1 to 100 characters, no control characters and no spaces at its ends, was \"a\\033b\"",
        "\"key.on=no | the scene has nothing named '\"key', did you mean 'key'?",
        "\"key\"on=no | an edit must be written as NAME.PROPERTY=VALUE, was '\"key\"on=no'",
        "\"key\" | an edit must be written as NAME.PROPERTY=VALUE, was '\"key\"'",
        "\"key\".on | an edit must be written as NAME.PROPERTY=VALUE, was '\"key\".on'",
        "\"picture\".depth=1 | the scene has nothing named 'picture'",
        "key.gains=\"bal\" 0.5 | there is no shape or group 'bal', did you mean 'ball'?",
        "key.gains=ball 0.5 | light 'key': gains: expected names of shapes or groups in quotes, each with a number, found 'ball'",
        "key.gains=\"ball\" | light 'key': gains: expected a number after '\"ball\"', found the end of the file",
        "key.gains=\"ball\" 0.5 \"ball\" 1 | light 'key': gains must name each shape once, found '\"ball\"' again",
        "key.gains=\"ball\" 101 | light 'key': gains must be from 0 to 100, was 101",
        "key.direction=0 0 0 | light 'key': direction must not be zero, was 0 0 0",
        "ball.material=flor | object 'ball': there is no material 'flor'",
        "floor.repeat=2 2 | material 'floor': repeat needs a texture, found none",
        "floor.texture=\"a.png\" | material 'floor': texture must be one that the scene already has, was 'a.png'",
        "material:flor.shininess=1 | there is no material 'flor', did you mean 'floor'?",
        "material:key.shininess=1 | there is no material 'key'",
        "material:floor.shininess=-1 | material 'floor': shininess must be ≥ 0, was -1",
        "material:floor.diffuse=1 1 2 | material 'floor': diffuse blue must be from 0 to 1, was 2",
        "camera.from=0 0 0 | camera: from and to must be different points",
        "picture.depth=1.5 | picture: depth must be a whole number, was 1.5",
    })
    void invalidEdit_isReported(String edit, String message) {
        assertThatThrownBy(() -> PropertyEdit.apply(scene, edit)).isInstanceOf(IllegalArgumentException.class).hasMessage(message);
    }

    @Test
    void unknownProperty_isReportedWithThoseOfTheTable() {
        List<String> names = MaterialAttribute.ALL.stream().flatMap(a -> a.kind() instanceof ValueKind.TextureKind map
                ? Stream.concat(Stream.of(a.name()), map.placement(a).stream().map(SceneAttribute::name)) : Stream.of(a.name()))
                .toList();
        assertThat(names).contains("texture", "repeat", "glow_map", "glow_repeat", "shininess", "shadows");
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "material:floor.shinines=1")).hasMessage(
                "material 'floor': unknown property 'shinines', expected one of " + String.join(", ", names)
                        + ", did you mean 'shininess'?");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "rim | expected a light's name and type, such as 'fill point', found 'rim'",
        "rim pint | light 'rim': type must be directional, point, spot, rect, disc, tube or object, was 'pint', did you mean 'point'?",
        "rim point intensity=-1 on=5 | light 'rim': intensity must be ≥ 0, was -1; light 'rim': on: expected yes or no, found '5'",
        "key point | light 'key': the name is already taken",
        "sphere s { } | expected one light, such as 'fill point intensity=0.5', found 'sphere s { }'",
        "light a point {} light b point {} | expected one light, such as 'fill point intensity=0.5', found 'light a point {} "
                + "light b point {}'",
    })
    void invalidNewLight_isReported(String light, String message) {
        assertThatThrownBy(() -> PropertyEdit.add(scene, light)).isInstanceOf(IllegalArgumentException.class).hasMessage(message);
    }

    @Test
    void value_isAcceptedInFileSyntax() {
        for (Property<Light> p : BlockTypes.LIGHT.properties()) {
            Value current = p.getter().apply(key);
            String value = current instanceof Value.Absent ? "none" : current.text();
            assertThat(PropertyEdit.set(scene, "key", p.name(), value)).as(p.name()).isEqualTo(scene);
        }
        assertThat(List.of("color", "at", "solo")).isSubsetOf(BlockTypes.LIGHT.propertyNames());
    }

    private Material floor(String edit) {
        return PropertyEdit.apply(scene, "material:floor." + edit).materials().getFirst();
    }

    private Light key(String edit) {
        Scene edited = PropertyEdit.apply(scene, "key." + edit);
        assertThat(edited.lights().get(1)).isEqualTo(scene.lights().get(1));
        return edited.light("key").orElseThrow();
    }

    private static Scene read(String text) {
        try {
            return JenReader.read(text, "s.jen", Path.of("")).scene();
        } catch (JenException e) {
            throw new AssertionError(e);
        }
    }
}
