package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.exchange.json.AttributeJson;
import lightning.format.gltf.GltfFixtures;
import lightning.format.ies.IesReader;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.sample.AttributeArbitraries;
import lightning.sample.TryFolder;
import lightning.scene.Scene;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.light.Falloff;
import lightning.scene.light.Influence;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.value.Attenuation;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.lifecycle.AfterProperty;
import net.jqwik.api.lifecycle.BeforeProperty;
import org.assertj.core.data.Offset;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Round trip of lights through glTF and JSON: every attribute of the table is preserved. */
class LightSettingsTest {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final LightGroup GROUP = new LightGroup("keys", new Rgb(1, 0.5, 0.25), 3, true, false);
    private static final Light RICH = Light.of("lamp", LightType.SPOT).withPosition(new Vec3(1, 2, 3)).withDirection(new Vec3(0, -3, 1))
            .withColor(new Rgb(2, 1, 0.3)).withIntensity(0.7).withAttenuation(new Attenuation(0.1, 0.2, 0.3)).withAngle(120).withDropoff(3)
            .withDoors(new BarnDoors(10, 20, 30, 40)).withFeather(5).withIlluminates(ShapeLinks.only("floor"))
            .withShadowedBy(ShapeLinks.except("floor"))
            .withInfluence(new Influence(false, 0.5, 2, 3, ShapeGains.of("floor", 0.25)));
    private TryFolder files;
    private Path gltf;
    private Scene scene;

    @BeforeProperty
    void setUp() throws Exception {
        files = new TryFolder();
        gltf = Files.write(files.file("a.gltf"), GltfFixtures.text(GltfFixtures.SQUARE_JSON, GltfFixtures.SQUARE));
        scene = imported(gltf).scene();
    }

    @AfterProperty
    void tearDown() throws IOException {
        files.close();
    }

    /** Lights without files, alone or in a bank; {@link #existingFiles_areRestored} covers files. */
    @Provide
    Arbitrary<LightRig> rigs() {
        return Combinators.combine(AttributeArbitraries.lights(), Arbitraries.of(true, false), Arbitraries.of(true, false))
                .as((changed, isGrouped, isOn) -> {
                    Light light = changed.after().withGobo(Optional.empty()).withProfile(Optional.empty()).withTexture(Optional.empty())
                            .retainLinks("floor"::equals);
                    return LightRig.of(List.of(isGrouped ? light.withLightGroup(GROUP.name()) : light), List.of(GROUP.withOn(isOn)));
                });
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void anyLight_roundTripsThroughGltf(@ForAll("rigs") LightRig rig) throws Exception {
        for (LightUnits units : LightUnits.values()) {
            Scene reimported = imported(exported(rig, units)).scene();
            assertSame(reimported.lights().getFirst(), rig.lights().getFirst());
            assertThat(reimported.rig().lightGroups())
                    .isEqualTo(rig.lights().getFirst().lightGroup().isEmpty() ? List.of() : rig.lightGroups());
        }
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void anyLight_roundTripsThroughJson(@ForAll("rigs") LightRig rig) {
        JsonNode root = JSON.readTree(LightExport.toJson(AnimatedScene.of(scene.withRig(rig))).bytes());
        Light blank = Light.of(rig.lights().getFirst().name(), LightType.DISC);
        assertSame(AttributeJson.read(root.get("lights").get(0), blank, LightAttribute.ALL, (_, _) -> false, AssertionError::new),
                rig.lights().getFirst());
        assertThat(
                AttributeJson.read(root.get("banks").get(0), LightGroup.of(GROUP.name()), LightGroup.ATTRIBUTES, (_, _) -> false,
                        AssertionError::new))
                .isEqualTo(rig.lightGroups().getFirst());
    }

    private static void assertSame(Light actual, Light expected) {
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            assertThat(attribute.get(actual)).as(attribute.title()).isEqualTo(attribute.get(expected));
        }
        assertThat(actual).isEqualTo(expected);
    }

    @Example
    void lightOfAnObject_keepsItsColorInItsGroup() throws Exception {
        Light light = Light.of("lamp", LightType.OBJECT).withColor(new Rgb(0.5, 0.4, 0.05)).withIntensity(0.7)
                .withFalloff(Falloff.INVERSE_SQUARE);
        LightRig rig = LightRig.of(List.of(light.withArea(light.area().withShape("floor")).withLightGroup(GROUP.name())), List.of(GROUP));
        LightRig reimported = imported(exported(rig, LightUnits.CANDELA)).scene().rig();
        assertSame(reimported.lights().getFirst(), rig.lights().getFirst());
        assertThat(reimported.lightGroups()).isEqualTo(rig.lightGroups());
    }

    @Example
    void disabledLight_keepsItsIntensity() throws Exception {
        Path file = exported(LightRig.of(List.of(RICH.withOn(false))), LightUnits.UNITLESS);
        assertThat(light(JSON.readTree(Files.readAllBytes(file))).get("intensity").asDouble()).isPositive();
        Light reimported = imported(file).scene().lights().getFirst();
        assertThat(reimported.on()).isFalse();
        assertThat(reimported.intensity()).isEqualTo(0.7);
    }

    @Example
    void externalEdits_overrideSettings() throws Exception {
        Path file = exported(LightRig.of(List.of(RICH.withLightGroup("keys")), List.of(GROUP)), LightUnits.CANDELA);
        Light original = imported(changed(file, _ -> {})).scene().lights().getFirst();
        assertThat(original).isEqualTo(RICH.withLightGroup("keys"));
        Light moved = imported(changed(file, root -> ((ObjectNode) root.get("nodes").get(1)).putArray("translation").add(7).add(8).add(9)))
                .scene().lights().getFirst();
        assertThat(moved).isEqualTo(original.withPosition(new Vec3(7, 8, 9)));
        Light rotated =
                imported(changed(file, root -> ((ObjectNode) root.get("nodes").get(1)).remove("rotation"))).scene().lights().getFirst();
        assertThat(rotated).isEqualTo(original.withDirection(rotated.direction()));
        assertThat(rotated.direction().minus(new Vec3(0, 0, -1)).maxAbs()).isZero();
        Light dimmed = imported(changed(file, root -> ((ObjectNode) light(root)).put("intensity", 683))).scene().lights().getFirst();
        assertThat(dimmed.intensity() / dimmed.attenuation().quadratic()).isEqualTo(1 / Math.PI, Offset.offset(1e-12));
        assertThat(dimmed).isEqualTo(original.withIntensity(dimmed.intensity()).withColor(dimmed.color())
                .withAttenuation(dimmed.attenuation()).withLightGroup(""));
        Light narrowed = imported(changed(file, root -> ((ObjectNode) light(root).get("spot")).put("outerConeAngle", 1))).scene().lights()
                .getFirst();
        assertThat(narrowed).isEqualTo(original.withAngle(Math.toDegrees(1)).withDropoff(0).withProfile(narrowed.profile()));
    }

    @Example
    void unusableSettings_areNotedAndCounted() throws Exception {
        Path file = exported(LightRig.of(List.of(RICH)), LightUnits.CANDELA);
        ImportedScene imported = imported(changed(file, root -> {
            ObjectNode settings = (ObjectNode) light(root).get("extras").get("lightning");
            settings.put("feather", "much").put("samples", 1e9).put("type", "candle").put("gobo", "../../secret.png").put("profile",
                    "none.ies");
            settings.putArray("up").add(1);
            settings.putObject("illuminates").put("only", true).putArray("names").add("not there");
        }));
        assertThat(imported.notes()).containsEntry("light settings that cannot be restored", 6)
                .containsEntry("light links to missing objects", 1);
        assertThat(imported.scene().lights().getFirst()).isEqualTo(RICH.withFeather(0).withIlluminates(ShapeLinks.NONE));
        for (String invalid : List.of("7", "[]", "{}", "{\"lightning\": 3}", "{\"lightning\": {\"light_units\": 5}}")) {
            Light restored =
                    imported(changed(file, root -> ((ObjectNode) light(root)).set("extras", JSON.readTree(invalid)))).scene().lights()
                            .getFirst();
            assertThat(restored.illuminates()).as(invalid).isEqualTo(ShapeLinks.ALL);
        }
    }

    @Example
    void existingFiles_areRestored() throws Exception {
        Files.copy(Path.of("textures/gobo_window.png"), files.file("window.png"));
        Files.copy(Path.of("textures/downlight.ies"), files.file("lamp.ies"));
        Files.copy(Path.of("textures/evening_sky.hdr"), files.file("screen.hdr"));
        Light light = RICH.withGobo(Optional.of(new Gobo("window.png", new Texture(1, 1, new float[3]))))
                .withProfile(Optional.of(new IesProfile("lamp.ies", IesReader.read(Path.of("textures/downlight.ies")))))
                .withTexture(Optional.of(new LightTexture("screen.hdr", new Texture(1, 1, new float[3]))));
        ImportedScene imported =
                SceneImporter.read(exported(LightRig.of(List.of(light)), LightUnits.CANDELA), files.file("b.jen"), LightUnits.CANDELA,
                        Progress.NONE);
        imported.write();
        Light reimported = JenReader.read(files.file("b.jen")).scene().lights().getFirst();
        assertThat(reimported.gobo().orElseThrow().file()).isEqualTo("window.png");
        assertThat(reimported.profile()).isEqualTo(light.profile());
        assertThat(reimported.texture().orElseThrow().file()).isEqualTo("screen.hdr");
        assertThat(reimported.withGobo(Optional.empty()).withProfile(Optional.empty()).withTexture(Optional.empty())).isEqualTo(RICH);
    }

    @Example
    void linkedAndDarkLights_areNoted() throws Exception {
        assertThat(LightExport.toGltf(gltf, scene.withRig(LightRig.of(List.of(RICH.withOn(false)))), LightUnits.CANDELA, Progress.NONE)
                .notes())
                .containsEntry("light linking, exported as illuminating everything", 1)
                .containsEntry("lights without shadows", 1).containsEntry("diffuse and specular gains of lights", 1)
                .containsEntry("lights that are off, exported as on", 1);
    }

    private static JsonNode light(JsonNode root) {
        return root.get("extensions").get("KHR_lights_punctual").get("lights").get(0);
    }

    private Path changed(Path file, Consumer<JsonNode> edit) throws IOException {
        JsonNode root = JSON.readTree(Files.readAllBytes(file));
        edit.accept(root);
        return Files.write(files.file("changed.gltf"), JSON.writeValueAsBytes(root));
    }

    private Path exported(LightRig rig, LightUnits units) throws Exception {
        return Files.write(files.file("back.gltf"), LightExport.toGltf(gltf, scene.withRig(rig), units, Progress.NONE).bytes());
    }

    private ImportedScene imported(Path file) throws IOException, MeshException {
        return SceneImporter.read(file, files.file("a.jen"), LightUnits.CANDELA, Progress.NONE);
    }
}
