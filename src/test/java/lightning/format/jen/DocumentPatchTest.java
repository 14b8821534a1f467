package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DocumentPatchTest {
    private static final String TEXT = """
            # Two lights.
            jen 1

            light key spot {      # the main one
              color 1.0 0.90 0.8  intensity 1.20   # warm
              at 3 5 2
            }
            light fill point { intensity 0.5 }  # from the left
            """;

    @TempDir
    Path folder;

    @Test
    void uneditedScene_hasTheSameText() throws Exception {
        JenDocument document = read(TEXT);
        assertThat(document.withScene(read(TEXT).scene()).text()).isEqualTo(TEXT);
    }

    @Test
    void editedNumber_isTheOnlyChange() throws Exception {
        assertThat(edited("key.color=1 0.5 0.8")).isEqualTo(TEXT.replace("0.90", "0.5"));
    }

    @Test
    void nonDefaultProperty_isAdded() throws Exception {
        assertThat(edited("key.angle=20")).isEqualTo(TEXT.replace("  at 3 5 2\n", "  at 3 5 2\n  angle 20\n"));
        assertThat(edited("fill.on=no")).isEqualTo(TEXT.replace("intensity 0.5 }", "intensity 0.5  on no }"));
        assertThat(edited("key.solo=no")).isEqualTo(TEXT);
    }

    @Test
    void commentAfterLastProperty_staysInPlace() throws Exception {
        JenDocument document = read("jen 1\nlight a point {\n  at 1 2 3 # here\n}\n");
        assertThat(document.withScene(PropertyEdit.apply(document.scene(), "a.on=no")).text())
                .isEqualTo("jen 1\nlight a point {\n  at 1 2 3 # here\n  on no\n}\n");
    }

    @Test
    void emptyBlock_acceptsAProperty() throws Exception {
        JenDocument document = read("jen 1\nlight a point {}\n");
        assertThat(document.withScene(PropertyEdit.apply(document.scene(), "a.on=no")).text())
                .isEqualTo("jen 1\nlight a point { on no }\n");
    }

    @Test
    void typeAndName_areReplacedInHeader() throws Exception {
        assertThat(edited("key.type=point")).isEqualTo(TEXT.replace("key spot", "key point"));
        assertThat(edited("fill.name=rim")).isEqualTo(TEXT.replace("fill", "rim"));
    }

    @Test
    void addedLight_isAppended() throws Exception {
        JenDocument document = read(TEXT);
        assertThat(document.withScene(PropertyEdit.add(document.scene(), "rim directional color=1 0 0")).text())
                .isEqualTo(TEXT + "light rim directional { color 1 0 0 }\n");
    }

    @Test
    void deletedLight_isRemoved() throws Exception {
        JenDocument document = read(TEXT);
        assertThat(document.withScene(PropertyEdit.delete(document.scene(), "key")).text())
                .isEqualTo("# Two lights.\njen 1\n\nlight fill point { intensity 0.5 }  # from the left\n");
    }

    @Test
    void reorderedLights_areSwapped() throws Exception {
        JenDocument document = read("jen 1\nlight a point { on no } # A\nlight b spot {} # B\n");
        assertThat(document.withScene(document.scene().withLights(document.scene().lights().reversed())).text())
                .isEqualTo("jen 1\nlight b spot {} # A\nlight a point { on no } # B\n");
    }

    @Test
    void missingBlock_isAddedAfterVersion() throws Exception {
        assertThat(edited("picture.depth=5")).isEqualTo(TEXT.replace("jen 1\n", "jen 1\npicture { depth 5 }\n"));
        assertThat(read("jen 1 world {}").withScene(read("jen 1 picture { size 3 4 }").scene()).text())
                .isEqualTo("jen 1\npicture { size 3 4 }\n world {}");
    }

    @Test
    void removedTexture_removesItsRepeat() throws Exception {
        var image = new Texture(1, 1, new float[3]);
        var untextured = Material.of("m").withDiffuse(Rgb.WHITE).withShininess(1);
        var textured =
                Material.of("m").withDiffuse(Rgb.WHITE).withShininess(1).withTexture(Optional.of(new TextureMap("a.png", 2, 3, image)));
        Scene scene = read("jen 1").scene();
        JenDocument textureMap = read("jen 1\nmaterial m { diffuse 1 1 1  shininess 1 }\n").withScene(material(scene, textured));
        assertThat(textureMap.text()).isEqualTo("jen 1\nmaterial m { diffuse 1 1 1  shininess 1  texture \"a.png\"  repeat 2 3 }\n");
        assertThat(textureMap.withScene(material(scene, untextured)).text())
                .isEqualTo("jen 1\nmaterial m { diffuse 1 1 1  shininess 1 }\n");
    }

    @Test
    void invalidTextureName_isRejectedBeforeWriting() throws Exception {
        var material = Material.of("m").withDiffuse(Rgb.WHITE).withShininess(1)
                .withTexture(Optional.of(new TextureMap("../a.png", 1, 1, new Texture(1, 1, new float[3]))));
        Scene scene = material(read("jen 1").scene(), material);
        assertThatThrownBy(() -> JenWriter.write(scene)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> read("jen 1").withScene(scene)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void windowsLineEnds_areRetained() throws Exception {
        JenDocument document = read("jen 1\r\nlight a point {\r\n  at 1 2 3\r\n}");
        Scene scene = PropertyEdit.add(PropertyEdit.apply(document.scene(), "a.angle=1"), "b point");
        assertThat(document.withScene(scene).text())
                .isEqualTo("jen 1\r\nlight a point {\r\n  at 1 2 3\r\n  angle 1\r\n}\r\nlight b point {}\r\n");
    }

    @Test
    void groupNodes_areAddedAndRemovedInPlace() throws Exception {
        JenDocument document = read("jen 1\ngroup g {\n  sphere a {}\n  # last\n}\n");
        Scene other = read("jen 1 group g { cone c { at 1 0 0 } }").scene();
        assertThat(document.withScene(other).text()).isEqualTo("jen 1\ngroup g {\n  # last\n  cone c { at 1 0 0 }\n}\n");
    }

    @Test
    void newScene_omitsDefaults() throws Exception {
        Light key = Light.of("key", LightType.SPOT).withPosition(new Vec3(0, -0.0, 1e12)).withIntensity(1e-7);
        Scene scene = read("jen 1").scene().withWorld(new World(0.5, Rgb.BLACK)).withLights(List.of(key));
        assertThat(JenDocument.of(scene).text())
                .isEqualTo("jen 1\n\nworld { ambience 0.5 }\n\nlight key spot { intensity 1e-7  at 0 -0 1e12 }\n");
    }

    @Test
    void savedFile_hasTheText() throws Exception {
        Path file = folder.resolve("s.jen");
        JenDocument document = read(TEXT);
        document.save(file);
        assertThat(file).hasContent(TEXT);
        assertThat(JenReader.read(file).scene()).isEqualTo(document.scene());
    }

    @Test
    void failedSave_retainsTheOldFile() throws Exception {
        JenDocument document = read(TEXT);
        assertThatThrownBy(() -> document.save(folder.resolve("none/s.jen"))).isInstanceOf(IOException.class);
        assertThat(Files.list(folder)).isEmpty();
    }

    private static Scene material(Scene s, Material m) {
        return new Scene(s.picture(), s.camera(), s.world(), List.of(m), s.nodes(), s.lights());
    }

    private String edited(String edit) throws JenException {
        JenDocument document = read(TEXT);
        return document.withScene(PropertyEdit.apply(document.scene(), edit)).text();
    }

    private JenDocument read(String text) throws JenException {
        return JenReader.read(text, "s.jen", folder);
    }
}
