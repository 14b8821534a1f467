package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Optional;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.SurfaceMaps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that textures of KHR_materials_specular, _clearcoat and _sheen become maps. */
class GltfLayerMapsTest {
    private static final int RED = 51;
    private static final int GREEN = 102;
    private static final int BLUE = 255;
    private static final int ALPHA = 153;

    @TempDir
    private Path folder;

    /** Returns a pixel as PNG. */
    private static String pixel(int type) throws IOException {
        var image = new BufferedImage(1, 1, type);
        image.setRGB(0, 0, ALPHA << 24 | RED << 16 | GREEN << 8 | BLUE);
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return Base64.getEncoder().encodeToString(out.toByteArray());
    }

    private ImportedScene importJson(String material) throws IOException, MeshException {
        String json = GltfFixtures.SQUARE_JSON.replace("'indices': 3", "'indices': 3, 'material': 0").replace("'buffers':",
                "'textures': [{'source': 0}, {'source': 1}], 'images': [{'name': 'a', 'uri': 'data:image/png;base64,"
                        + pixel(BufferedImage.TYPE_INT_ARGB) + "'}, {'name': 'b', 'uri': 'data:image/png;base64,"
                        + pixel(BufferedImage.TYPE_INT_RGB) + "'}], 'materials': [" + material + "], 'buffers':");
        return SceneImporter.read(Files.write(folder.resolve("a.glb"), GltfFixtures.binary(json, GltfFixtures.SQUARE)),
                folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    /** Returns the first material of an imported scene, with its images. */
    private Material written(ImportedScene imported) throws Exception {
        imported.write();
        return JenReader.read(folder.resolve("a.jen")).scene().materials().getFirst();
    }

    private Material extended(String extension, String content) throws Exception {
        return written(
                importJson("{'extensions': {'" + extension + "': {" + content + "}}, 'pbrMetallicRoughness': {'metallicFactor': 0}}"));
    }

    private static double value(Optional<TextureMap> map, TextureChannel channel) {
        return map.orElseThrow().image().channel(0, 0, channel.ordinal());
    }

    @Test
    void clearcoatTextures_areWeightInRedAndRoughnessInGreen() throws Exception {
        Material material = extended("KHR_materials_clearcoat", "'clearcoatFactor': 0.5, 'clearcoatRoughnessFactor': 0.25,"
                + " 'clearcoatTexture': {'index': 1}, 'clearcoatRoughnessTexture': {'index': 1}");
        LayerMaps maps = material.layerMaps();
        assertThat(material.coat().weight()).isEqualTo(0.5);
        assertThat(material.coat().roughness()).isEqualTo(0.25);
        assertThat(value(maps.coat(), maps.coatChannel())).isEqualTo(RED / 255f);
        assertThat(value(maps.coatRoughness(), maps.coatRoughnessChannel())).isEqualTo(GREEN / 255f);
    }

    @Test
    void clearcoatNormalTexture_isNormalMapOfCoat() throws Exception {
        Material material =
                extended("KHR_materials_clearcoat", "'clearcoatFactor': 1, 'clearcoatNormalTexture': {'index': 1, 'scale': 0.5}");
        assertThat(value(material.layerMaps().coatNormal(), TextureChannel.GREEN)).isEqualTo(GREEN / 255f);
        assertThat(material.layerMaps().coatStrength()).isEqualTo(0.5);
        assertThat(material.bumpMapping().isFlat()).isTrue();
    }

    @Test
    void specularTextures_areLevelInAlphaAndTint() throws Exception {
        Material material = extended("KHR_materials_specular", "'specularTexture': {'index': 0}, 'specularColorTexture': {'index': 0}");
        SurfaceMaps maps = material.surfaceMaps();
        assertThat(material.f0()).isCloseTo(0.04, within(1e-12));
        assertThat(material.specularTint()).isEqualTo(Rgb.WHITE);
        assertThat(value(maps.f0(), maps.f0Channel())).isCloseTo(ALPHA / 255.0, within(1e-4));
        // The color is sRGB: 51/255 is linear 0.0331.
        assertThat(value(maps.specularTint(), TextureChannel.RED)).isCloseTo(0.0331, within(1e-4));
    }

    @Test
    void specularTextureWithoutAlpha_changesNothing() throws Exception {
        assertThat(extended("KHR_materials_specular", "'specularTexture': {'index': 1}").surfaceMaps()).isEqualTo(SurfaceMaps.NONE);
    }

    /** The roughness in alpha, 0.5·0.6 = 0.3, is that of another lobe. */
    @Test
    void sheenTextures_areColorAndRoughnessInAlpha() throws Exception {
        Material material = extended("KHR_materials_sheen", "'sheenColorFactor': [0, 0.5, 1], 'sheenRoughnessFactor': 0.5,"
                + " 'sheenColorTexture': {'index': 1}, 'sheenRoughnessTexture': {'index': 0}");
        LayerMaps maps = material.layerMaps();
        assertThat(material.sheen().color()).isEqualTo(new Rgb(0, 0.5, 1));
        assertThat(value(maps.sheen(), TextureChannel.GREEN)).isCloseTo(0.1329, within(1e-4));
        assertThat(material.sheen().roughness() * value(maps.sheenRoughness(), maps.sheenRoughnessChannel()))
                .isCloseTo(0.155 + 0.93 * 0.3 - 0.3 * 0.09, within(1e-4));
    }

    @Test
    void texturesOfReadExtensions_areNotNoted() throws Exception {
        ImportedScene imported = importJson("{'extensions': {'KHR_materials_clearcoat': {'clearcoatFactor': 1,"
                + " 'clearcoatTexture': {'index': 1}}, 'KHR_materials_sheen': {'sheenColorFactor': [1, 1, 1],"
                + " 'sheenColorTexture': {'index': 1}}, 'KHR_materials_specular': {'specularColorTexture': {'index': 1}}},"
                + " 'pbrMetallicRoughness': {'metallicFactor': 0}}");
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("Texture"));
    }

    @Test
    void texturesOfClearGlass_areNoted() throws Exception {
        assertThat(importJson("{'extensions': {'KHR_materials_specular': {'specularColorTexture': {'index': 1}},"
                + " 'KHR_materials_transmission': {'transmissionFactor': 1}},"
                + " 'pbrMetallicRoughness': {'metallicFactor': 0, 'roughnessFactor': 0}}").notes())
                .containsEntry("specularColorTexture of materials", 1);
    }

    @Test
    void textureWithCoordinatesOfItsOwn_isNoted() throws Exception {
        assertThat(importJson("{'extensions': {'KHR_materials_clearcoat': {'clearcoatFactor': 1, 'clearcoatTexture':"
                + " {'index': 1, 'texCoord': 1}}}, 'pbrMetallicRoughness': {'baseColorTexture': {'index': 1}}}").notes())
                .containsEntry("clearcoatTexture of materials with texture coordinates of its own, placed like other textures", 1);
    }
}
