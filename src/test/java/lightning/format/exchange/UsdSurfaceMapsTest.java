package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.base.math.SrgbCurve;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenReader;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.sample.PythonPrograms;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.Coat;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.SurfaceMaps;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Textures of roughness, metalness and opacity of stages, through usd-core. */
class UsdSurfaceMapsTest {
    private static final String STAGE = SquareStage.text("/look", 2) + """
            def Material "look"
            {
                token outputs:surface.connect = </look/surface.outputs:surface>
                def Shader "surface"
                {
                    uniform token info:id = "UsdPreviewSurface"
                    %s
                    token outputs:surface
                }
                def Shader "image"
                {
                    uniform token info:id = "UsdUVTexture"
                    asset inputs:file = @%s@
                    %s
                    float outputs:r
                    float outputs:g
                    float outputs:b
                    float outputs:a
                }
            }
            """;
    private static final String ROUGH = "float inputs:roughness.connect = </look/image.outputs:%s>";
    /** The left pixel has red 51, green 102, blue 153 and alpha 204; the right one has none of them. */
    private static final int LEFT = 0xCC336699;
    /** Opacity is read with eight bits. */
    private static final double OPACITY_STEP = 0.5 / 255;
    @TempDir
    private Path folder;
    private ImportedScene imported;

    @BeforeEach
    void requireUsd() throws Exception {
        PythonPrograms.require("pxr");
        writeImage(BufferedImage.TYPE_INT_ARGB);
    }

    private void writeImage(int type) throws Exception {
        var image = new BufferedImage(2, 1, type);
        image.setRGB(0, 0, LEFT);
        image.setRGB(1, 0, 0);
        ImageIO.write(image, "png", folder.resolve("a.png").toFile());
    }

    private Material material(String surface, String image) throws Exception {
        return material(surface, image, "a.png");
    }

    private Material material(String surface, String image, String file) throws Exception {
        Path stage = Files.writeString(folder.resolve("a.usda"), String.format(Locale.ROOT, STAGE, surface, file, image));
        Path scene = Files.createDirectories(folder.resolve("scene")).resolve("a.jen");
        imported = SceneImporter.read(stage, scene, LightUnits.CANDELA, Progress.NONE);
        imported.write();
        return JenReader.read(scene).scene().material("look").orElseThrow();
    }

    private Material rough(String output, String image) throws Exception {
        return material(String.format(Locale.ROOT, ROUGH, output), image);
    }

    private Material rough(String output, String image, String file) throws Exception {
        return material(String.format(Locale.ROOT, ROUGH, output), image, file);
    }

    /** Returns the roughness that a pixel of a map gives. */
    private static double roughness(Material material, int x) {
        SurfaceMaps maps = material.surfaceMaps();
        return material.mappedRoughness(maps.roughness().orElseThrow().image().channel(x, 0, maps.roughnessChannel().ordinal()));
    }

    @Test
    void channels_becomeThoseOfTheMaps() throws Exception {
        Material material = material(String.format(Locale.ROOT, ROUGH, "g") + "\nfloat inputs:metallic.connect = </look/image.outputs:b>",
                "token inputs:wrapS = \"clamp\"");
        SurfaceMaps maps = material.surfaceMaps();
        assertThat(maps.roughnessChannel()).isEqualTo(TextureChannel.GREEN);
        assertThat(maps.metalnessChannel()).isEqualTo(TextureChannel.BLUE);
        assertThat(maps.roughness().map(TextureMap::file)).contains("a.png").isEqualTo(maps.metalness().map(TextureMap::file));
        assertThat(maps.roughness().orElseThrow().wrap().word()).isEqualTo("clamp_repeat");
        assertThat(material.metalness()).isEqualTo(1);
        assertThat(roughness(material, 0)).isCloseTo(102 / 255.0, offset(1e-6));
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("textures"));
    }

    @Test
    void redChannel_isRead() throws Exception {
        assertThat(roughness(rough("r", ""), 0)).isCloseTo(51 / 255.0, offset(1e-6));
    }

    @Test
    void scale_becomesTheFactor() throws Exception {
        Material material = rough("g", "float4 inputs:scale = (1, 0.5, 1, 1)");
        assertThat(material.roughness()).isEqualTo(0.5);
        assertThat(material.surfaceMaps().roughness().map(TextureMap::file)).contains("a.png");
    }

    @Test
    void scaleAndBias_areWrittenToAnImage() throws Exception {
        Material material = rough("g", "float4 inputs:scale = (1, -0.5, 1, 1)\nfloat4 inputs:bias = (0, 0.75, 0, 0)");
        assertThat(roughness(material, 0)).isCloseTo(0.75 - 0.5 * 102 / 255, offset(1.0 / 65535));
        assertThat(roughness(material, 1)).isCloseTo(0.75, offset(1.0 / 65535));
        assertThat(material.surfaceMaps().roughness().map(TextureMap::file)).contains("a-roughness.png");
    }

    @Test
    void scaleAboveOne_isLimitedPointByPoint() throws Exception {
        Material material = rough("b", "float4 inputs:scale = (1, 1, 4, 1)\nfloat4 inputs:bias = (0, 0, 0.25, 0)");
        assertThat(roughness(material, 0)).isEqualTo(1);
        assertThat(roughness(material, 1)).isCloseTo(0.25, offset(1.0 / 65535));
    }

    @Test
    void alpha_isReadAsNumbers() throws Exception {
        assertThat(roughness(rough("a", ""), 0)).isCloseTo(204 / 255.0, offset(1.0 / 65535));
    }

    @Test
    void imageWithoutAlpha_isOpaque() throws Exception {
        writeImage(BufferedImage.TYPE_INT_RGB);
        assertThat(roughness(rough("a", "float4 inputs:scale = (1, 1, 1, 0.5)"), 1)).isCloseTo(0.5, offset(1.0 / 65535));
    }

    @Test
    void numbersInSrgb_areConverted() throws Exception {
        assertThat(roughness(rough("g", "token inputs:sourceColorSpace = \"sRGB\""), 0))
                .isCloseTo(SrgbCurve.toLinear(102 / 255.0), offset(1.0 / 65535));
    }

    @Test
    void valuesOfExrAboveOne_areLimitedAfterScaleAndBias() throws Exception {
        ImageFile.write(folder.resolve("n.exr"), Film.ofScanlines(2, 1, new float[] {2, 0, 0, 0.5f, 0, 0}), ViewTransform.DEFAULT);
        Material material = rough("r", "float4 inputs:scale = (0.25, 1, 1, 1)\nfloat4 inputs:bias = (0.125, 0, 0, 0)", "n.exr");
        assertThat(roughness(material, 0)).isCloseTo(0.625, offset(1.0 / 65535));
        assertThat(roughness(material, 1)).isCloseTo(0.25, offset(1.0 / 65535));
    }

    @Test
    void specularWorkflow_hasNoMetalness() throws Exception {
        Material material = material("float inputs:metallic.connect = </look/image.outputs:b>\nint inputs:useSpecularWorkflow = 1", "");
        assertThat(material.metalness()).isZero();
        assertThat(material.surfaceMaps().metalness()).isEmpty();
    }

    @Test
    void texturesOfCoat_areMapsOfTheirChannels() throws Exception {
        Material material = material("float inputs:clearcoat.connect = </look/image.outputs:b>\n"
                + "float inputs:clearcoatRoughness.connect = </look/image.outputs:g>", "float4 inputs:scale = (1, 0.5, 0.5, 1)");
        LayerMaps maps = material.layerMaps();
        assertThat(material.coat()).isEqualTo(new Coat(0.5, 0.5, 1.5));
        assertThat(maps.coat().orElseThrow().image().channel(0, 0, maps.coatChannel().ordinal())).isEqualTo(153 / 255f);
        assertThat(maps.coatRoughness().orElseThrow().image().channel(0, 0, maps.coatRoughnessChannel().ordinal()))
                .isEqualTo(102 / 255f);
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("clearcoat"));
    }

    /** 153 of sRGB is linear 0.3185. */
    @Test
    void textureOfSpecularColor_isTint() throws Exception {
        Material material = material("color3f inputs:specularColor.connect = </look/image.outputs:rgb>\nint inputs:useSpecularWorkflow = 1",
                "float4 inputs:scale = (0.5, 0.5, 0.25, 1)\nfloat3 outputs:rgb");
        assertThat(material.f0()).isEqualTo(0.5);
        assertThat(material.specularTint()).isEqualTo(new Rgb(1, 1, 0.5));
        assertThat(material.surfaceMaps().specularTint().orElseThrow().image().channel(0, 0, 2)).isCloseTo(0.3185f, offset(1e-3f));
    }

    /** The mean of the left pixel and 0. */
    @Test
    void transparentMaterial_hasTheMean() throws Exception {
        Material veil = material(String.format(Locale.ROOT, ROUGH, "g") + "\nfloat inputs:opacity = 0.5", "");
        assertThat(veil.transmission().isTransparent()).isTrue();
        assertThat(veil.roughness()).isCloseTo(51 / 255.0, offset(1e-6));
        assertThat(imported.notes()).containsEntry("roughness textures of transparent materials, averaged: 'a.png'", 1);
    }

    @Test
    void missingImage_isNoted() throws Exception {
        Files.delete(folder.resolve("a.png"));
        assertThat(rough("g", "").roughness()).isEqualTo(0.5);
        assertThat(imported.notes()).containsEntry("roughness textures of materials", 1).containsEntry("textures that are missing", 1);
    }

    private Material cutout(String output, String image) throws Exception {
        return material("float inputs:opacityThreshold = 0.25\nfloat inputs:opacity.connect = </look/image.outputs:" + output + ">", image);
    }

    private static double opacity(Material material, int x) {
        return material.cutout().map().orElseThrow().image().channel(x, 0, 0);
    }

    @Test
    void alphaOfOpacity_isThatOfTheImage() throws Exception {
        Material leaf = cutout("a", "");
        assertThat(leaf.cutout().map().map(TextureMap::file)).contains("a.png");
        assertThat(opacity(leaf, 0)).isCloseTo(204 / 255.0, offset(1e-6));
        assertThat(leaf.cutout().cutoff()).isEqualTo(0.25);
    }

    @Test
    void grayImageOfOpacity_isCopied() throws Exception {
        ImageIO.write(new BufferedImage(2, 1, BufferedImage.TYPE_BYTE_GRAY), "png", folder.resolve("a.png").toFile());
        assertThat(cutout("r", "").cutout().map().map(TextureMap::file)).contains("a.png");
    }

    @Test
    void otherChannelOfOpacity_isRead() throws Exception {
        assertThat(opacity(cutout("r", ""), 0)).isCloseTo(51 / 255.0, offset(OPACITY_STEP));
    }

    @Test
    void channelOfImageWithoutAlpha_isRead() throws Exception {
        writeImage(BufferedImage.TYPE_INT_RGB);
        assertThat(opacity(cutout("b", ""), 0)).isCloseTo(153 / 255.0, offset(OPACITY_STEP));
    }

    @Test
    void scaleAndBiasOfOpacity_areWrittenToAnImage() throws Exception {
        Material leaf = cutout("a", "float4 inputs:scale = (1, 1, 1, -0.5)\nfloat4 inputs:bias = (0, 0, 0, 0.75)");
        assertThat(opacity(leaf, 0)).isCloseTo(0.75 - 0.5 * 204 / 255, offset(OPACITY_STEP));
        assertThat(opacity(leaf, 1)).isCloseTo(0.75, offset(OPACITY_STEP));
    }

    @Test
    void alphaOfImageWithoutAlpha_hidesNothing() throws Exception {
        writeImage(BufferedImage.TYPE_INT_RGB);
        assertThat(cutout("a", "").cutout().map()).isEmpty();
    }
}
