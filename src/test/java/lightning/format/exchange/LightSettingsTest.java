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
import lightning.format.gltf.Gltf;
import lightning.format.ies.IesReader;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.sample.AttributeArbitraries;
import lightning.scene.Attenuation;
import lightning.scene.Bank;
import lightning.scene.BarnDoors;
import lightning.scene.Gobo;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.Links;
import lightning.scene.Profile;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Texture;
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

/** Lights that go into a glTF file, or a JSON, and come back have every attribute of the table. */
class LightSettingsTest {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final Bank BANK = new Bank("keys", new Rgb(1, 0.5, 0.25), 3, true, false);
    private static final Light RICH = Light.of("lamp", LightType.SPOT).withPosition(new Vec3(1, 2, 3)).withDirection(new Vec3(0, -3, 1))
            .withColor(new Rgb(2, 1, 0.3)).withIntensity(0.7).withAttenuation(new Attenuation(0.1, 0.2, 0.3)).withAngle(120).withDropoff(3)
            .withDoors(new BarnDoors(10, 20, 30, 40)).withFeather(5).withIlluminates(Links.only("floor"))
            .withShadowedBy(Links.except("floor"));
    private Path folder;
    private Path gltf;
    private Scene scene;

    @BeforeProperty
    void bringIn() throws Exception {
        folder = Files.createTempDirectory("lights");
        gltf = Files.write(folder.resolve("a.gltf"), Gltf.text(Gltf.SQUARE_JSON, Gltf.SQUARE));
        scene = imported(gltf).scene();
    }

    @AfterProperty
    void clearAway() throws IOException {
        try (var files = Files.list(folder)) {
            for (Path file : files.toList()) {
                Files.delete(file);
            }
        }
        Files.delete(folder);
    }

    /** Lights without files, which {@link #filesThatTheSceneFinds_areRestored} has, alone or in a bank. */
    @Provide
    Arbitrary<Rig> rigs() {
        return Combinators.combine(AttributeArbitraries.lights(), Arbitraries.of(true, false), Arbitraries.of(true, false))
                .as((changed, banked, on) -> {
                    Light light = changed.after().withGobo(Optional.empty()).withProfile(Optional.empty())
                            .withIlluminates(changed.after().illuminates().within("floor"::equals))
                            .withShadowedBy(changed.after().shadowedBy().within("floor"::equals));
                    return Rig.of(List.of(banked ? light.withBank(BANK.name()) : light), List.of(BANK.withOn(on)));
                });
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void anyLight_comesBackFromGltfWithEveryAttribute(@ForAll("rigs") Rig rig) throws Exception {
        for (LightUnits units : LightUnits.values()) {
            Scene again = imported(back(rig, units)).scene();
            assertSame(again.lights().getFirst(), rig.lights().getFirst());
            assertThat(again.rig().banks()).isEqualTo(rig.lights().getFirst().bank().isEmpty() ? List.of() : rig.banks());
        }
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void anyLight_isWholeInTheJson(@ForAll("rigs") Rig rig) {
        JsonNode root = JSON.readTree(LightsBack.json(scene.withRig(rig)).bytes());
        Light blank = Light.of(rig.lights().getFirst().name(), LightType.DISC);
        assertSame(AttributeJson.read(root.get("lights").get(0), blank, LightAttribute.ALL, (_, _) -> false, AssertionError::new),
                rig.lights().getFirst());
        assertThat(
                AttributeJson.read(root.get("banks").get(0), Bank.of(BANK.name()), Bank.ATTRIBUTES, (_, _) -> false, AssertionError::new))
                .isEqualTo(rig.banks().getFirst());
    }

    private static void assertSame(Light actual, Light expected) {
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            assertThat(attribute.of(actual)).as(attribute.title()).isEqualTo(attribute.of(expected));
        }
        assertThat(actual).isEqualTo(expected);
    }

    @Example
    void lightThatIsOff_keepsItsIntensity() throws Exception {
        Path file = back(Rig.of(List.of(RICH.withOn(false))), LightUnits.UNITLESS);
        assertThat(light(JSON.readTree(Files.readAllBytes(file))).get("intensity").asDouble()).isPositive();
        Light again = imported(file).scene().lights().getFirst();
        assertThat(again.on()).isFalse();
        assertThat(again.intensity()).isEqualTo(0.7);
    }

    @Example
    void whatAnotherProgramChanged_countsAsItSays() throws Exception {
        Path file = back(Rig.of(List.of(RICH.withBank("keys")), List.of(BANK)), LightUnits.CANDELA);
        Light before = imported(changed(file, _ -> {})).scene().lights().getFirst();
        assertThat(before).isEqualTo(RICH.withBank("keys"));
        Light moved = imported(changed(file, root -> ((ObjectNode) root.get("nodes").get(1)).putArray("translation").add(7).add(8).add(9)))
                .scene().lights().getFirst();
        assertThat(moved).isEqualTo(before.withPosition(new Vec3(7, 8, 9)));
        Light turned =
                imported(changed(file, root -> ((ObjectNode) root.get("nodes").get(1)).remove("rotation"))).scene().lights().getFirst();
        assertThat(turned).isEqualTo(before.withDirection(turned.direction()));
        assertThat(turned.direction().minus(new Vec3(0, 0, -1)).maxAbs()).isZero();
        Light dimmed = imported(changed(file, root -> ((ObjectNode) light(root)).put("intensity", 683))).scene().lights().getFirst();
        assertThat(dimmed.intensity() / dimmed.attenuation().quadratic()).isEqualTo(1 / Math.PI, Offset.offset(1e-12));
        assertThat(dimmed).isEqualTo(before.withIntensity(dimmed.intensity()).withColor(dimmed.color())
                .withAttenuation(dimmed.attenuation()).withBank(""));
        Light narrowed = imported(changed(file, root -> ((ObjectNode) light(root).get("spot")).put("outerConeAngle", 1))).scene().lights()
                .getFirst();
        assertThat(narrowed).isEqualTo(before.withAngle(Math.toDegrees(1)).withDropoff(narrowed.dropoff()));
    }

    @Example
    void settingsThatCannotBeUsed_areToldAndCounted() throws Exception {
        Path file = back(Rig.of(List.of(RICH)), LightUnits.CANDELA);
        Import read = imported(changed(file, root -> {
            ObjectNode own = (ObjectNode) light(root).get("extras").get("lightning");
            own.put("feather", "much").put("samples", 1e9).put("type", "candle").put("gobo", "../../secret.png").put("profile", "none.ies");
            own.putArray("up").add(1);
            own.putObject("illuminates").put("only", true).putArray("names").add("not there");
        }));
        assertThat(read.notes()).containsEntry("settings of lights that cannot be used here", 6)
                .containsEntry("lights linked to shapes that are not there", 1);
        assertThat(read.scene().lights().getFirst()).isEqualTo(RICH.withFeather(0).withIlluminates(Links.NONE));
        for (String odd : List.of("7", "[]", "{}", "{\"lightning\": 3}", "{\"lightning\": {\"light_units\": 5}}")) {
            Light plain = imported(changed(file, root -> ((ObjectNode) light(root)).set("extras", JSON.readTree(odd)))).scene().lights()
                    .getFirst();
            assertThat(plain.illuminates()).as(odd).isEqualTo(Links.ALL);
        }
    }

    @Example
    void filesThatTheSceneFinds_areRestored() throws Exception {
        Files.copy(Path.of("textures/gobo_window.png"), folder.resolve("window.png"));
        Files.copy(Path.of("textures/downlight.ies"), folder.resolve("lamp.ies"));
        Light light = RICH.withGobo(Optional.of(new Gobo("window.png", new Texture(1, 1, new float[3]))))
                .withProfile(Optional.of(new Profile("lamp.ies", IesReader.read(Path.of("textures/downlight.ies")))));
        Import read =
                Importer.read(back(Rig.of(List.of(light)), LightUnits.CANDELA), folder.resolve("b.jen"), LightUnits.CANDELA, Progress.NONE);
        read.write();
        Light again = JenReader.read(folder.resolve("b.jen")).scene().lights().getFirst();
        assertThat(again.gobo().orElseThrow().file()).isEqualTo("window.png");
        assertThat(again.profile()).isEqualTo(light.profile());
        assertThat(again.withGobo(Optional.empty()).withProfile(Optional.empty())).isEqualTo(RICH);
    }

    @Example
    void linkedAndDarkLights_areAmongTheRemarks() throws Exception {
        assertThat(LightsBack.into(gltf, scene.withRig(Rig.of(List.of(RICH.withOn(false)))), LightUnits.CANDELA, Progress.NONE).notes())
                .containsEntry("lights linked to shapes, which shine on all there", 1)
                .containsEntry("lights that are dark, which shine there", 1);
    }

    private static JsonNode light(JsonNode root) {
        return root.get("extensions").get("KHR_lights_punctual").get("lights").get(0);
    }

    private Path changed(Path file, Consumer<JsonNode> edit) throws IOException {
        JsonNode root = JSON.readTree(Files.readAllBytes(file));
        edit.accept(root);
        return Files.write(folder.resolve("changed.gltf"), JSON.writeValueAsBytes(root));
    }

    private Path back(Rig rig, LightUnits units) throws Exception {
        return Files.write(folder.resolve("back.gltf"), LightsBack.into(gltf, scene.withRig(rig), units, Progress.NONE).bytes());
    }

    private Import imported(Path file) throws IOException, MeshException {
        return Importer.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
    }
}
