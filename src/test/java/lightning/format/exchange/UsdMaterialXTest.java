package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.asset.TextureFile;
import lightning.sample.PythonPrograms;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureUsage;
import lightning.scene.material.Coat;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.Sheen;
import lightning.scene.material.SurfaceMaps;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** MaterialX networks in stages and in files of their own, through usd-core. */
class UsdMaterialXTest {
    private static final String NETWORK = """
            def Material "look"
            {
                token outputs:mtlx:surface.connect = </look/surface.outputs:surface>
                def Shader "surface"
                {
                    uniform token info:id = "%s"
                    %s
                    token outputs:surface
                }
                def Shader "image"
                {
                    uniform token info:id = "ND_image_color3"
                    asset inputs:file = @a.png@
                    float2 inputs:texcoord.connect = </look/place.outputs:out>
                    color3f outputs:out
                }
                def Shader "place"
                {
                    uniform token info:id = "ND_place2d_vector2"
                    float2 inputs:scale = (0.5, 0.25)
                    float2 outputs:out
                }
                def Shader "tint"
                {
                    uniform token info:id = "ND_constant_color3"
                    color3f inputs:value = (0.5, 0.25, 1)
                    color3f outputs:out
                }
                def Shader "tinted"
                {
                    uniform token info:id = "ND_multiply_color3"
                    color3f inputs:in1.connect = </look/image.outputs:out>
                    color3f inputs:in2.connect = </look/tint.outputs:out>
                    color3f outputs:out
                }
                def Shader "blue"
                {
                    uniform token info:id = "ND_separate3_color3"
                    color3f inputs:in.connect = </look/image.outputs:out>
                    float outputs:outb
                }
                def Shader "inverted"
                {
                    uniform token info:id = "ND_invert_float"
                    float inputs:in.connect = </look/blue.outputs:outb>
                    float outputs:out
                }
                def Shader "half"
                {
                    uniform token info:id = "ND_multiply_float"
                    float inputs:in1.connect = </look/blue.outputs:outb>
                    float inputs:in2 = 0.5
                    float outputs:out
                }
                def Shader "more"
                {
                    uniform token info:id = "ND_add_float"
                    float inputs:in1.connect = </look/half.outputs:out>
                    float inputs:in2 = 0.125
                    float outputs:out
                }
                def Shader "moved"
                {
                    uniform token info:id = "ND_remap_float"
                    float inputs:in.connect = </look/more.outputs:out>
                    float inputs:inhigh = 0.5
                    float inputs:outlow = 0.25
                    float inputs:outhigh = 0.75
                    float outputs:out
                }
                def Shader "bumps"
                {
                    uniform token info:id = "ND_normalmap_float"
                    float3 inputs:in.connect = </look/image.outputs:out>
                    float inputs:scale = 0.5
                    float3 outputs:out
                }
            }
            """;
    @TempDir
    private Path folder;
    private ImportedScene imported;

    @BeforeEach
    void requireUsd() throws Exception {
        PythonPrograms.require("pxr");
        var image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 4; i++) {
            image.setRGB(i % 2, i / 2, 0xFF0033);
        }
        ImageIO.write(image, "png", folder.resolve("a.png").toFile());
    }

    private Material imported(String stage) throws Exception {
        Path file = Files.writeString(folder.resolve("a.usda"), stage);
        imported = SceneImporter.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
        return imported.scene().materials().stream().findFirst().orElse(null);
    }

    private Material network(String surface, String inputs) throws Exception {
        return imported(SquareStage.text("/look", 1)
                + String.format(Locale.ROOT, NETWORK, "ND_" + surface + "_surfaceshader", inputs));
    }

    @Test
    void standardSurface_isPrincipledMaterial() throws Exception {
        Material material = network("standard_surface", """
                float inputs:base = 0.5
                color3f inputs:base_color.connect = </look/tinted.outputs:out>
                float inputs:metalness.connect = </look/blue.outputs:outb>
                float inputs:specular_roughness = 0.75
                float3 inputs:normal.connect = </look/bumps.outputs:out>
                color3f inputs:emission_color.connect = </look/image.outputs:out>
                """);
        TextureMap map = material.texture().orElseThrow();
        assertThat(map.repeatU()).isEqualTo(2);
        assertThat(map.repeatV()).isEqualTo(4);
        assertThat(material.base()).isEqualTo(new Rgb(0.25, 0.125, 0.5));
        assertThat(material.metalness()).isEqualTo(1);
        assertThat(material.surfaceMaps().metalness().map(TextureMap::repeatV)).contains(4.0);
        assertThat(material.surfaceMaps().metalnessChannel()).isEqualTo(TextureChannel.BLUE);
        assertThat(material.roughness()).isEqualTo(0.75);
        assertThat(material.bumpMapping().normalMap()).isPresent();
        assertThat(material.bumpMapping().strength()).isEqualTo(0.5);
        // A texture of emission without a weight does not glow.
        assertThat(material.glow()).isEqualTo(Rgb.BLACK);
    }

    /** At (0.5, 0.5): less the pivot, divided by (0.5, 0.25), turned clockwise, less the offset, plus the pivot. */
    @Test
    void place2d_turnsAboutItsPivot() throws Exception {
        String nodes = String.format(Locale.ROOT, NETWORK, "ND_standard_surface_surfaceshader",
                "color3f inputs:base_color.connect = </look/image.outputs:out>").replace("float2 inputs:scale = (0.5, 0.25)", """
                        float2 inputs:scale = (0.5, 0.25)
                        float inputs:rotate = 90
                        float2 inputs:offset = (0.125, 0.25)
                        float2 inputs:pivot = (0.25, 0.375)
                        """);
        TextureMap map = imported(SquareStage.text("/look", 1) + nodes).texture().orElseThrow();
        TexturePlacement placement = map.placement();
        double u = 0.5 * map.repeatU();
        double v = 0.5 * map.repeatV();
        // Turned clockwise, (0.5, 0.5) becomes (0.5, −0.5).
        assertThat(Math.IEEEremainder(placement.cosine() * u - placement.sine() * v + placement.offsetU() - (0.5 - 0.125 + 0.25), 1))
                .isCloseTo(0, offset(1e-6));
        assertThat(Math.IEEEremainder(placement.sine() * u + placement.cosine() * v + placement.offsetV() - (-0.5 - 0.25 + 0.375), 1))
                .isCloseTo(0, offset(1e-6));
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("textures"));
    }

    private Material gltfImage(String kind, String inputs, String surface) throws Exception {
        String nodes = String.format(Locale.ROOT, NETWORK, "ND_gltf_pbr_surfaceshader", surface).replace("ND_image_color3", kind)
                .replace("float2 inputs:texcoord.connect = </look/place.outputs:out>", inputs);
        return imported(SquareStage.text("/look", 1) + nodes);
    }

    /** As in a glTF file: the image of a point (u, v), v downwards, is at (0.25 + 2 v, 0.5 − 3 u) by a rotation by a quarter. */
    @Test
    void gltfImage_isPlacedByItsTransform() throws Exception {
        TextureMap map = gltfImage("ND_gltf_image_color3_color3_1_0", """
                float2 inputs:scale = (3, 2)
                float inputs:rotate = 90
                float2 inputs:offset = (0.25, 0.5)
                """, "color3f inputs:base_color.connect = </look/image.outputs:out>").texture().orElseThrow();
        TexturePlacement placement = map.placement();
        for (double[] point : new double[][] {{0, 0}, {0.25, 0.125}, {0.75, 0.5}}) {
            double u = map.repeatU() * point[0];
            double v = map.repeatV() * (1 - point[1]);
            double imageU = placement.cosine() * u - placement.sine() * v + placement.offsetU();
            double imageV = placement.sine() * u + placement.cosine() * v + placement.offsetV();
            assertThat(Math.IEEEremainder(imageU - (0.25 + 2 * point[1]), 1)).isCloseTo(0, offset(1e-6));
            assertThat(Math.IEEEremainder(1 - imageV - (0.5 - 3 * point[0]), 1)).isCloseTo(0, offset(1e-6));
        }
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("textures are") || note.contains("scale"));
    }

    @Test
    void gltfImage_isMultipliedByItsFactor() throws Exception {
        assertThat(gltfImage("ND_gltf_image_color3_color3_1_0", "color3f inputs:factor = (0.5, 0.25, 1)",
                "color3f inputs:base_color.connect = </look/image.outputs:out>").base()).isEqualTo(new Rgb(0.5, 0.25, 1));
    }

    @Test
    void gltfColorImage_hasItsColorAndAlpha() throws Exception {
        var image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, 0xCC336699);
        ImageIO.write(image, "png", folder.resolve("a.png").toFile());
        Material leaf = gltfImage("ND_gltf_colorimage", """
                color4f inputs:color = (0.5, 0.25, 1, 0.5)
                color3f outputs:outcolor
                float outputs:outa
                """, """
                color3f inputs:base_color.connect = </look/image.outputs:outcolor>
                float inputs:alpha.connect = </look/image.outputs:outa>
                int inputs:alpha_mode = 1
                """);
        assertThat(leaf.base()).isEqualTo(new Rgb(0.5, 0.25, 1));
        assertThat(number(leaf.cutout().map(), TextureChannel.RED)).isCloseTo(0.5 * 0xCC / 255, offset(1.0 / 65535));
    }

    /** The blue channel of the image is 0x33. */
    @Test
    void arithmeticOfOpacity_isExact() throws Exception {
        Material leaf = network("gltf_pbr", "float inputs:alpha.connect = </look/inverted.outputs:out>\nint inputs:alpha_mode = 1");
        assertThat(number(leaf.cutout().map(), TextureChannel.RED)).isCloseTo(1 - 0x33 / 255.0, offset(1.0 / 65535));
    }

    /** The blue channel of the image is 0x33, each node changes it in turn. */
    @Test
    void arithmeticOfTextures_isExact() throws Exception {
        Material material = network("open_pbr_surface", """
                float inputs:base_metalness.connect = </look/inverted.outputs:out>
                float inputs:specular_roughness.connect = </look/moved.outputs:out>
                """);
        double blue = 0x33 / 255.0;
        assertThat(number(material.surfaceMaps().metalness(), material.surfaceMaps().metalnessChannel())).isCloseTo(1 - blue,
                offset(1.0 / 65535));
        assertThat(number(material.surfaceMaps().roughness(), material.surfaceMaps().roughnessChannel()))
                .isCloseTo(0.25 + (0.75 - 0.25) * ((blue * 0.5 + 0.125) / 0.5), offset(1.0 / 65535));
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("shading n"));
    }

    private double number(Optional<TextureMap> map, TextureChannel channel) throws Exception {
        imported.write();
        byte[] file = Files.readAllBytes(folder.resolve(map.orElseThrow().file()));
        return TextureFile.decode("map", file, TextureUsage.DATA).channel(0, 0, channel.ordinal());
    }

    @Test
    void coatAndSpecular_areThoseOfOpenPbr() throws Exception {
        Material paint = network("open_pbr_surface", """
                float inputs:coat_weight = 0.75
                float inputs:coat_roughness = 0.125
                float inputs:specular_ior = 2
                float inputs:specular_weight = 0.5
                color3f inputs:specular_color = (1, 0.5, 0.25)
                """);
        assertThat(paint.coat()).isEqualTo(new Coat(0.75, 0.125, 1.6));
        // Half of (1/3)².
        assertThat(paint.f0()).isCloseTo(1 / 18.0, offset(1e-8));
        assertThat(paint.specularTint()).isEqualTo(new Rgb(1, 0.5, 0.25));
        assertThat(imported.notes().keySet()).noneMatch(note -> note.startsWith("colors of coats"));
    }

    @Test
    void fuzz_isSheen() throws Exception {
        Material velvet = network("open_pbr_surface", """
                float inputs:fuzz_weight = 0.5
                color3f inputs:fuzz_color = (1, 0.5, 0)
                float inputs:fuzz_roughness = 0.25
                """);
        assertThat(velvet.sheen()).isEqualTo(new Sheen(new Rgb(0.5, 0.25, 0), 0.25));
    }

    @Test
    void texturesOfOpenPbr_areMaps() throws Exception {
        Material material = network("open_pbr_surface", """
                float inputs:specular_weight.connect = </look/blue.outputs:outb>
                color3f inputs:specular_color.connect = </look/image.outputs:out>
                float inputs:coat_weight.connect = </look/blue.outputs:outb>
                float inputs:coat_roughness.connect = </look/blue.outputs:outb>
                float inputs:fuzz_weight = 0.5
                color3f inputs:fuzz_color.connect = </look/image.outputs:out>
                float inputs:fuzz_roughness.connect = </look/blue.outputs:outb>
                """);
        SurfaceMaps maps = material.surfaceMaps();
        LayerMaps layers = material.layerMaps();
        assertThat(List.of(maps.f0(), maps.specularTint(), layers.coat(), layers.coatRoughness(), layers.sheen(), layers.sheenRoughness()))
                .allMatch(Optional::isPresent);
        assertThat(List.of(maps.f0Channel(), layers.coatChannel(), layers.coatRoughnessChannel(), layers.sheenRoughnessChannel()))
                .containsOnly(TextureChannel.BLUE);
        assertThat(material.f0()).isCloseTo(0.04, offset(1e-8));
        assertThat(material.coat()).isEqualTo(new Coat(1, 1, 1.6));
        assertThat(material.sheen()).isEqualTo(new Sheen(Rgb.gray(0.5), 1));
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("textures of"));
    }

    @Test
    void normalMapOfCoat_isThatOfTheCoat() throws Exception {
        Material material =
                network("standard_surface", "float inputs:coat = 1\nfloat3 inputs:coat_normal.connect = </look/bumps.outputs:out>");
        assertThat(material.layerMaps().coatNormal()).isPresent();
        assertThat(material.layerMaps().coatStrength()).isEqualTo(0.5);
        assertThat(material.bumpMapping().isFlat()).isTrue();
        assertThat(network("standard_surface", "float3 inputs:coat_normal.connect = </look/bumps.outputs:out>").layerMaps().coatNormal())
                .as("without a coat").isEmpty();
    }

    @Test
    void roughnessTextureOfAnotherSheen_isItsMean() throws Exception {
        Material material = network("standard_surface", """
                float inputs:sheen = 1
                float inputs:sheen_roughness.connect = </look/blue.outputs:outb>
                """);
        assertThat(material.layerMaps().sheenRoughness()).isEmpty();
        assertThat(imported.notes().keySet())
                .anyMatch(note -> note.startsWith("sheenRoughness textures of sheens of another lobe, averaged"));
    }

    @Test
    void sheen_isThatOfStandardSurface() throws Exception {
        Sheen sheen = network("standard_surface", """
                float inputs:sheen = 0.5
                color3f inputs:sheen_color = (1, 0.5, 0)
                float inputs:sheen_roughness = 1
                """).sheen();
        assertThat(sheen.color()).isEqualTo(new Rgb(0.5, 0.25, 0));
        // A ball with that lobe sends 0.2993 of white light back; Cycles has 0.2406 at 0.7 and 0.3106 at 0.8.
        assertThat(sheen.roughness()).isCloseTo(0.7 + 0.1 * (0.2993 - 0.2406) / (0.3106 - 0.2406), offset(0.012));
    }

    /** The mean square of the widths of OpenPBR is α², and their ratio 1 − anisotropy. */
    @Test
    void anisotropy_keepsTheWidthsOfOpenPbr() throws Exception {
        Material material = network("open_pbr_surface", """
                float inputs:specular_roughness = 0.5
                float inputs:specular_roughness_anisotropy = 0.6
                """);
        double along = material.anisotropy().along(material.alpha());
        double across = material.anisotropy().across(material.alpha());
        assertThat((along * along + across * across) / 2).isCloseTo(0.0625, offset(1e-6));
        assertThat(across / along).isCloseTo(0.4, offset(1e-6));
    }

    @Test
    void anisotropy_hasTheRatioAndTheRotationOfStandardSurface() throws Exception {
        Material material = network("standard_surface", """
                float inputs:specular_roughness = 0.5
                float inputs:specular_anisotropy = 0.45
                float inputs:specular_rotation = 0.25
                """);
        assertThat(material.roughness()).isCloseTo(0.5, offset(1e-6));
        assertThat(material.anisotropy().strength()).isCloseTo(0.5, offset(1e-6));
        assertThat(material.anisotropy().rotation()).isEqualTo(90);
    }

    @Test
    void anisotropyOfGltfSurface_isThatOfItsExtension() throws Exception {
        Material material = network("gltf_pbr", """
                float inputs:roughness = 0.5
                float inputs:anisotropy_strength = 1
                """);
        // Widths 1 and 1/4.
        assertThat(material.alpha()).isCloseTo(0.5, offset(1e-6));
        assertThat(material.anisotropy().strength()).isCloseTo(0.75 / 0.9, offset(1e-6));
    }

    @Test
    void missingProperties_areNotedWithTheirMaterial() throws Exception {
        network("standard_surface", """
                float inputs:coat_anisotropy = 0.5
                float inputs:coat = 1
                color3f inputs:coat_color = (1, 0.5, 0.25)
                """);
        assertThat(imported.notes()).containsEntry("anisotropy of coats of materials: 'look'", 1)
                .containsEntry("colors of coats of materials: 'look'", 1);
    }

    @Test
    void texturesOfMissingProperties_areNotedWithTheirMaterial() throws Exception {
        network("standard_surface", """
                float inputs:sheen.connect = </look/blue.outputs:outb>
                float inputs:coat.connect = </look/blue.outputs:outb>
                color3f inputs:coat_color.connect = </look/image.outputs:out>
                float3 inputs:coat_normal.connect = </look/bumps.outputs:out>
                float inputs:transmission.connect = </look/blue.outputs:outb>
                """);
        assertThat(imported.notes()).doesNotContainKey("clearcoat textures of materials")
                .containsEntry("transmission textures of MaterialX surfaces", 1).containsEntry("sheen textures of MaterialX surfaces", 1)
                .containsEntry("colors of coats of materials: 'look'", 1);
    }

    @Test
    void previewSurface_hasCoatOfItsIndex() throws Exception {
        Material lacquer = imported(SquareStage.text("/look", 1) + """
                def Material "look"
                {
                    token outputs:surface.connect = </look/s.outputs:surface>
                    def Shader "s"
                    {
                        uniform token info:id = "UsdPreviewSurface"
                        float inputs:clearcoat = 0.5
                        float inputs:clearcoatRoughness = 0.25
                        float inputs:ior = 1.75
                        int inputs:useSpecularWorkflow = 1
                        color3f inputs:specularColor = (0.25, 0.5, 0.125)
                        token outputs:surface
                    }
                }
                """);
        assertThat(lacquer.coat()).isEqualTo(new Coat(0.5, 0.25, 1.75));
        assertThat(lacquer.f0()).isEqualTo(0.5);
        assertThat(lacquer.specularTint()).isEqualTo(new Rgb(0.5, 1, 0.25));
    }

    @Test
    void glass_hasTintOfItsTransmission() throws Exception {
        Material glass = network("standard_surface", """
                float inputs:base = 0
                float inputs:transmission = 1
                color3f inputs:transmission_color = (0.5, 1, 0.75)
                float inputs:specular_IOR = 1.54
                """);
        assertThat(glass.transmission().ior()).isEqualTo(1.54);
        assertThat(glass.transmission().color()).isEqualTo(new Rgb(0.5, 1, 0.75));
        Material pbr = network("open_pbr_surface", """
                float inputs:geometry_opacity = 0.25
                float inputs:emission_luminance = 10
                color3f inputs:emission_color = (1, 0.5, 0.25)
                """);
        assertThat(pbr.glow()).isEqualTo(new Rgb(10, 5, 2.5));
        assertThat(pbr.transmission().color().max()).isPositive();
    }

    @Test
    void gltfSurface_keepsItsAlphaMode() throws Exception {
        String alpha = "float inputs:alpha.connect = </look/blue.outputs:outb>\ncolor3f inputs:base_color = (0.5, 0.5, 0.5)\n";
        assertThat(network("gltf_pbr", alpha).cutout().map()).isEmpty();
        Material masked = network("gltf_pbr", alpha + "int inputs:alpha_mode = 1\nfloat inputs:alpha_cutoff = 0.25");
        assertThat(masked.cutout().map()).isPresent();
        assertThat(masked.cutout().cutoff()).isEqualTo(0.25);
        assertThat(masked.metalness()).isEqualTo(1);
        assertThat(masked.base()).isEqualTo(new Rgb(0.5, 0.5, 0.5));
    }

    @Test
    void otherNetworks_areNoted() throws Exception {
        network("standard_surface", "color3f inputs:base_color.connect = </look/place.outputs:out>");
        assertThat(imported.notes()).containsEntry("shading networks other than a texture", 1);
        imported(SquareStage.text("/look", 1) + String.format(Locale.ROOT, NETWORK, "ND_lama_surface", ""));
        assertThat(imported.notes().keySet()).anyMatch(note -> note.startsWith("materials without a UsdPreviewSurface"));
    }

    @Test
    void materialFile_isRead() throws Exception {
        Files.writeString(folder.resolve("look.mtlx"), """
                <!-- a comment before the declaration, as some programs write -->
                <?xml version="1.0"?>
                <materialx version="1.38" fileprefix="./">
                  <xi:include href="library.mtlx"/>
                  <nodegraph name="NG">
                    <input name="file" type="filename" value="a.png"/>
                    <image name="color" type="color3">
                      <input name="file" type="filename" interfacename="file"/>
                    </image>
                    <output name="colored" type="color3" nodename="color"/>
                  </nodegraph>
                  <standard_surface name="SR" type="surfaceshader">
                    <input name="base_color" type="color3" nodegraph="NG" output="colored"/>
                    <input name="metalness" type="float" value="1"/>
                    <input name="specular_roughness" type="float" value="0.5"/>
                  </standard_surface>
                  <surfacematerial name="gold" type="material">
                    <input name="surfaceshader" type="surfaceshader" nodename="SR"/>
                  </surfacematerial>
                </materialx>
                """);
        String stage = SquareStage.text("/looks/gold", 1)
                + "def \"looks\" ( references = @./look.mtlx@</MaterialX/Materials> )\n{\n}\n";
        Material gold = imported(stage);
        assertThat(gold.name()).isEqualTo("gold");
        assertThat(gold.texture().orElseThrow().file()).isEqualTo("a.png");
        assertThat(gold.metalness()).isEqualTo(1);
        assertThat(gold.roughness()).isEqualTo(0.5);
        assertThat(imported.notes().keySet()).noneMatch(note -> note.startsWith("references that cannot be loaded"));
    }

    @Test
    void damagedMaterialFiles_areNoted() throws Exception {
        String stage = SquareStage.text("/looks/gold", 1)
                + "def \"looks\" ( references = @./look.mtlx@</MaterialX/Materials> )\n{\n}\n";
        for (String text : new String[] {"", "<materialx>", "<a/>", """
                <materialx><surfacematerial name="gold"><input name="surfaceshader" nodename="a"/></surfacematerial>
                <standard_surface name="a" type="surfaceshader"><input name="base" type="float" value="x"/></standard_surface></materialx>
                """, """
                <materialx><surfacematerial name="gold"><input name="surfaceshader" nodename="a"/></surfacematerial>
                <add name="a" type="float"><input name="in1" type="float" nodename="a"/></add></materialx>
                """,
            """
                    <!DOCTYPE a [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;">
                    <!ENTITY d "&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;"><!ENTITY e "&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;">
                    <!ENTITY f "&e;&e;&e;&e;&e;&e;&e;&e;&e;&e;"><!ENTITY g "&f;&f;&f;&f;&f;&f;&f;&f;&f;&f;">
                    <!ENTITY h "&g;&g;&g;&g;&g;&g;&g;&g;&g;&g;">]><materialx>&h;</materialx>
                    """}) {
            Files.writeString(folder.resolve("look.mtlx"), text);
            imported(stage);
            assertThat(imported.scene().placedShapes()).hasSize(1);
            assertThat(imported.notes().keySet()).as(text).anyMatch(note -> note.startsWith("MaterialX files")
                    || note.startsWith("references that") || note.startsWith("objects without a material")
                    || note.startsWith("materials without") || note.contains("of a MaterialX file: expected"));
        }
    }
}
