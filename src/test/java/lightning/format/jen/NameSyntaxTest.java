package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Names of arbitrary characters, in files and in edits. */
class NameSyntaxTest {
    private static final String TEXT = """
            jen 1
            material "old oak" { shininess 3 }  # of the table
            group "dining table" at 0 0 2 { sphere "apple \\"red\\"" { material "old oak" } }
            plane floor { material "old oak" }
            light "key light" spot { intensity 2 }
            light "1.5 = \\\\" point {}
            """;

    @Provide
    Arbitrary<String> names() {
        Arbitrary<Integer> special = Arbitraries.of(" \"\\.={}#':-_1٣aÄ👩\u200D\u0301ß".codePoints().boxed().toList());
        Arbitrary<Integer> any = Arbitraries.integers().between(0x20, 0x10FFFF);
        return Arbitraries.oneOf(special, any).list().ofMinSize(1).ofMaxSize(SceneLimits.MAX_NAME)
                .map(all -> new String(all.stream().mapToInt(c -> c).toArray(), 0, all.size())).filter(NameSyntaxTest::isAllowed);
    }

    private static boolean isAllowed(String name) {
        try {
            SceneLimits.checkName(name);
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    @Test
    void quotedNames_areRead() throws JenException {
        Scene scene = read(TEXT);
        assertThat(scene.lights()).extracting(Light::name).containsExactly("key light", "1.5 = \\");
        assertThat(scene.materials().getFirst().name()).isEqualTo("old oak");
        NodeGroup table = (NodeGroup) scene.nodes().getFirst();
        assertThat(table.name()).isEqualTo("dining table");
        assertThat(table.children().getFirst()).isEqualTo(new Shape(Solid.SPHERE, "apple \"red\"", "old oak", Placement.IDENTITY));
    }

    @Test
    void onlyNonWords_areQuoted() throws JenException {
        assertThat(JenWriter.write(read(TEXT))).contains("material \"old oak\" {", "group \"dining table\" {",
                "sphere \"apple \\\"red\\\"\" { material \"old oak\" }", "plane floor {", "light \"key light\" spot",
                "light \"1.5 = \\\\\" point");
        assertThat(JenWriter.write(read("jen 1 light \"key\" point {}"))).contains("light key point");
    }

    @Test
    void renaming_changesOnlyTheName() throws JenException {
        JenDocument document = JenReader.read(TEXT, "n.jen", Path.of(""));
        Scene scene = document.scene();
        Scene renamed = scene.withLights(List.of(scene.lights().get(0).withName("key"), scene.lights().get(1).withName("\"b\"")));
        assertThat(document.withScene(renamed).text())
                .isEqualTo(TEXT.replace("\"key light\"", "key").replace("\"1.5 = \\\\\"", "\"\\\"b\\\"\""));
    }

    @Test
    void unneededQuotes_stay() throws JenException {
        String text = "jen 1\nmaterial \"oak\" {}\nsphere \"s\" { material \"oak\" }\nlight \"key\" point {}\n";
        JenDocument document = JenReader.read(text, "n.jen", Path.of(""));
        Scene dimmer = PropertyEdit.apply(document.scene(), "key.intensity=2");
        assertThat(document.withScene(dimmer).text()).isEqualTo(text.replace("key\" point {}", "key\" point { intensity 2 }"));
    }

    @Test
    void composedAndDecomposedLetters_areDistinctNames() throws JenException {
        assertThat(read("jen 1 light \"é\" point {} light \"e\u0301\" point {}").lights()).hasSize(2);
        assertThatThrownBy(() -> read("jen 1 light \"e\u0301\" point {} light \"e\u0301\" point {}")).hasMessageContaining("unique");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "jen 1 light \"\" point {} | 1:13: a name must have 1 to 100 characters, no control characters and no spaces at its ends, was ''",
        "jen 1 light \"a \" point {} | 1:13: a name must have 1 to 100 characters, no control characters and no spaces at its ends, was 'a '",
        "jen 1 light \"a\u202Eb\" point {} | 1:13: a name must have 1 to 100 characters, no control characters and no spaces at its ends, was \"a\\342\\200\\256b\"",
        "jen 1 light \"a\\b\" point {} | 1:13: a '\\' in quotes must stand before '\"' or another '\\', found 'b'",
        "jen 1 light \"a\\\" point {} | 1:13: a '\"' must be closed by another in the same line",
        "jen 1 light \"a\"b point {} | 1:16: expected a space, found 'b'",
        "jen 1 sphere s { material \"old oak\" } | 1:27: sphere 's': there is no material 'old oak'",
        "jen 1 light 1 point {} | 1:13: light: expected a name, found '1'",
    })
    void invalidName_isRejectedWithLocation(String text, String problem) {
        assertThatThrownBy(() -> read(text)).isInstanceOfSatisfying(JenException.class,
                e -> assertThat(e.problems().getFirst()).hasToString("n.jen:" + problem));
    }

    @Property
    void anyName_roundTrips(@ForAll("names") String name) throws JenException {
        Scene scene = scene(name);
        assertThat(read(JenWriter.write(scene))).isEqualTo(scene);
    }

    @Property
    void anyRenaming_roundTrips(@ForAll("names") String oldName, @ForAll("names") String newName) throws JenException {
        JenDocument document = JenDocument.of(scene(oldName));
        JenDocument edited = document.withScene(scene(newName));
        assertThat(read(edited.text())).isEqualTo(scene(newName));
    }

    @Property
    void anyNameInQuotes_isFoundByEdits(@ForAll("names") String name) {
        Scene scene = scene(name);
        String quoted = '"' + name.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
        assertThat(PropertyEdit.apply(scene, quoted + ".intensity=7").lights().getFirst().intensity()).isEqualTo(7);
        assertThat(PropertyEdit.apply(scene, "material:" + quoted + ".shininess=7").materials().getFirst().shininess()).isEqualTo(7);
        assertThat(PropertyEdit.delete(scene, quoted).lights()).isEmpty();
        Scene empty = scene.withLights(List.of());
        assertThat(PropertyEdit.add(empty, quoted + " point intensity=2")).isEqualTo(scene);
        assertThat(PropertyEdit.add(empty, "light " + quoted + " point { intensity 2 }")).isEqualTo(scene);
        Scene other = scene.withLights(List.of(scene.lights().getFirst().withName("other")));
        assertThat(PropertyEdit.apply(other, "other.name=" + quoted)).isEqualTo(scene);
    }

    @ParameterizedTest
    @ValueSource(strings = {"key light", "key.2", "picture show"})
    void unquotedName_isFoundIfUnambiguous(String name) {
        Scene scene = scene(name);
        assertThat(PropertyEdit.apply(scene, name + ".intensity=7").lights().getFirst().intensity()).isEqualTo(7);
        assertThat(PropertyEdit.delete(scene, name).lights()).isEmpty();
    }

    @Test
    void quotedName_isNotAKeywordOrPrefix() {
        Scene scene = scene("picture").withLights(List.of(Light.of("picture", LightType.POINT), Light.of("material:m", LightType.POINT)));
        assertThat(PropertyEdit.apply(scene, "\"picture\".intensity=7").lights().getFirst().intensity()).isEqualTo(7);
        assertThat(PropertyEdit.apply(scene, "\"material:m\".intensity=7").lights().getLast().intensity()).isEqualTo(7);
        assertThat(PropertyEdit.apply(scene, "picture.depth=7").picture().depth()).isEqualTo(7);
    }

    /** Returns a scene with a material, a shape, a group and a light that differ only by their names. */
    private static Scene scene(String name) {
        Scene empty = EMPTY;
        String other = name.equals("g") ? "h" : "g";
        return new Scene(empty.picture(), empty.camera(), empty.world(),
                List.of(Material.of(name).withShininess(3)),
                List.of(new NodeGroup(other, Placement.IDENTITY, List.of(new Shape(Solid.CONE, other + "s", name, Placement.IDENTITY)))),
                List.of(Light.of(name.equals(other + "s") ? "l" : name, LightType.POINT).withIntensity(2)));
    }

    private static final Scene EMPTY = empty();

    private static Scene empty() {
        try {
            return read("jen 1");
        } catch (JenException e) {
            throw new AssertionError(e);
        }
    }

    private static Scene read(String text) throws JenException {
        return JenReader.read(text, "n.jen", Path.of("")).scene();
    }
}
