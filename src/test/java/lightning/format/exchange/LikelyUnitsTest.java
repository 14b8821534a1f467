package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import lightning.base.work.Progress;
import lightning.document.imports.ImportPreviews;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LikelyUnitsTest {
    @TempDir
    private Path folder;

    private ImportedScene read(String generator, Optional<LightUnits> units) throws Exception {
        Path file = Files.writeString(folder.resolve("lamp.gltf"), """
                {"asset": {"version": "2.0", "generator": %s}, "extensionsUsed": ["KHR_lights_punctual"],
                 "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 100}]}}, "scene": 0,
                 "scenes": [{"nodes": [0]}], "nodes": [{"extensions": {"KHR_lights_punctual": {"light": 0}}}]}
                """.replace("%s", generator));
        return SceneImporter.read(file, folder.resolve("lamp.jen"), ImportOptions.DEFAULT.withUnits(units), Progress.NONE);
    }

    @ParameterizedTest
    @CsvSource({"Khronos glTF Blender I/O v1.8.19, WATTS", "Khronos glTF Blender I/O v3.4.39, WATTS",
        "Khronos glTF Blender I/O v3.4.40, CANDELA", "Khronos glTF Blender I/O v4.2.70, CANDELA",
        "Khronos glTF Blender I/O v99999999999.1.1, CANDELA", "Khronos glTF Blender I/O v3, CANDELA", "another program, CANDELA"})
    void program_decidesTheUnits(String generator, LightUnits expected) throws Exception {
        assertThat(read("\"" + generator + "\"", Optional.empty()).units()).contains(expected);
    }

    @Test
    void unknownProgram_writesTheStandard() throws Exception {
        for (String generator : new String[] {"null", "5", "\"\"", "[]"}) {
            assertThat(read(generator, Optional.empty()).units()).as(generator).contains(LightUnits.CANDELA);
        }
    }

    @Test
    void choice_precedesTheProgram() throws Exception {
        assertThat(read("\"Khronos glTF Blender I/O v1.8.19\"", Optional.of(LightUnits.UNITLESS)).units()).contains(LightUnits.UNITLESS);
    }

    @Test
    void choices_beginWithStudioAndTheLikelyUnits() throws Exception {
        ImportedScene imported = read("\"Khronos glTF Blender I/O v1.8.19\"", Optional.empty());
        assertThat(new ImportPreviews(imported, 8).choices()).startsWith(
                new ImportPreviews.Choice(ImportLighting.STUDIO, Optional.empty()),
                new ImportPreviews.Choice(ImportLighting.FILE, Optional.of(LightUnits.WATTS)))
                .endsWith(new ImportPreviews.Choice(ImportLighting.SKY, Optional.empty())).hasSize(2 + LightUnits.values().length);
    }
}
