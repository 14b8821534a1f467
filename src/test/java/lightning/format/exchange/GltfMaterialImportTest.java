package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.base.math.SrgbCurve;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.render.image.Film;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap;
import lightning.scene.asset.TextureWrap.Edge;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Sheen;
import lightning.scene.material.SurfaceMaps;
import lightning.scene.material.Transmission;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Imported glTF materials, and their shading compared with the specification (appendix B). */
class GltfMaterialImportTest {
    private static final Vec3 EYE = new Vec3(0.5, -0.9, 0.8);
    private static final Vec3 BULB = new Vec3(0.8, 1.4, 0.7);
    private static final double WATTS_PER_STERADIAN = 2.5;
    /** Rotation of the camera about x, so that it looks along (0, sin 60°, −cos 60°). */
    private static final double ROTATION = Math.toRadians(60);
    private static final double YFOV = 0.5;
    /** Pixel with the values 128, 192, 255. */
    private static final String PIXEL =
            "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNoOPAfAAQDAkBvhCYaAAAAAElFTkSuQmCC";

    /** A black pixel. */
    private static final String BLACK =
            "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNgYGAAAAAEAAH2FzhVAAAAAElFTkSuQmCC";

    /** Largest relative error by the interpolation of albedos. */
    private static final double TABLE_ERROR = 0.01;

    @TempDir
    private Path folder;

    private ImportedScene importJson(String material) throws IOException, MeshException {
        return importJson(material, "", "");
    }

    private ImportedScene importJson(String material, String from, String to) throws IOException, MeshException {
        String json = GltfFixtures.SQUARE_JSON
                .replace("'nodes': [{'mesh': 0, 'name': 'floor'}]",
                        String.format(Locale.ROOT, """
                                'nodes': [{'mesh': 0, 'name': 'floor', 'children': [1, 2]},
                                  {'name': 'bulb', 'translation': [%s, %s, %s], 'extensions': {'KHR_lights_punctual': {'light': 0}}},
                                  {'name': 'eye', 'camera': 0, 'translation': [%s, %s, %s], 'rotation': [%s, 0, 0, %s]}],
                                 'extensions': {'KHR_lights_punctual': {'lights': [{'type': 'point', 'intensity': %s}]}},
                                 'cameras': [{'perspective': {'yfov': %s}}], 'textures': [{'source': 0}],
                                 'images': [{'uri': 'data:image/png;base64,%s'}],
                                 'materials': [%s]""", BULB.x(), BULB.y(), BULB.z(), EYE.x(), EYE.y(), EYE.z(), Math.sin(ROTATION / 2),
                                Math.cos(ROTATION / 2),
                                683 * WATTS_PER_STERADIAN, YFOV, PIXEL, material))
                .replace("'indices': 3", "'indices': 3, 'material': 0").replace(from, to);
        return SceneImporter.read(Files.write(folder.resolve("a.glb"), GltfFixtures.binary(json, GltfFixtures.SQUARE)),
                folder.resolve("a.jen"),
                LightUnits.CANDELA, Progress.NONE);
    }

    private Material material(String text) throws IOException, MeshException {
        return importJson(text).scene().materials().getFirst();
    }

    private static String surface(String numbers) {
        return "{'pbrMetallicRoughness': {" + numbers + "}}";
    }

    /**
     * Returns the BRDF of appendix B.3, a mix of a metal and a coated diffuse surface, for an irradiance of 1 perpendicular to the light. Not
     * as there: light that facets reflect several times is given back, and what the surface reflects is not scattered (see
     * render.shading.PrincipledWeights).
     *
     * @param albedo shares of white light that the surface reflects to the view: times F0, and independent of it
     */
    private static double specifiedBrdf(double base, double metallic, double roughness, double f0, Vec3 n, Vec3 l, Vec3 v,
            double[] albedo) {
        double alpha = roughness * roughness;
        Vec3 h = l.plus(v).normalized();
        double nl = n.dot(l);
        double nv = n.dot(v);
        double distribution = alpha * alpha / (Math.PI * Math.pow(n.dot(h) * n.dot(h) * (alpha * alpha - 1) + 1, 2));
        double mirrored = distribution * visible(nl, alpha) * visible(nv, alpha) / (4 * nl * nv);
        double grazing = Math.pow(1 - v.dot(h), 5);
        double several = Math.max(0, 1 - albedo[0] - albedo[1]) / Math.max(albedo[0], 0.25);
        double mean = metallic * base + (1 - metallic) * f0;
        double squares = metallic * base * base + (1 - metallic) * f0 * f0;
        double reflected = mirrored * ((mean + several * squares) * (1 - grazing) + grazing);
        double rest = 1 - f0 * albedo[0] - albedo[1] - several * f0 * f0 * albedo[0];
        return nl * (reflected + (1 - metallic) * base / Math.PI * rest);
    }

    /** Returns the share of facets that are visible from a direction. */
    private static double visible(double cosine, double alpha) {
        return 2 * cosine / (cosine + Math.sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine));
    }

    /** Returns what a surface of white facets reflects to the view, split by Schlick's term: an integral over normals of facets. */
    private static double[] albedo(double nv, double roughness) {
        double alpha = roughness * roughness;
        int count = 256;
        double[] sum = new double[2];
        for (int i = 0; i < count; i++) {
            double share = (i + 0.5) / count;
            double nh = Math.sqrt((1 - share) / (1 + (alpha * alpha - 1) * share));
            for (int k = 0; k < count; k++) {
                double angle = 2 * Math.PI * (k + 0.5) / count;
                double vh = Math.sqrt(1 - nv * nv) * Math.sqrt(1 - nh * nh) * Math.cos(angle) + nv * nh;
                double nl = 2 * vh * nh - nv;
                if (vh > 0 && nl > 0) {
                    double grazing = Math.pow(1 - vh, 5);
                    double weight = visible(nl, alpha) * visible(nv, alpha) * vh / (nv * nh) / (count * count);
                    sum[0] += weight * (1 - grazing);
                    sum[1] += weight * grazing;
                }
            }
        }
        return sum;
    }

    /**
     * Compares pixels with the specification at their visible points. Points and directions are floats: N·H is off by at most 8·2⁻²⁴, next to
     * a highlight whose slope is at most 4/α of its height. The shading interpolates albedos in a table of 32 × 32 places.
     */
    @ParameterizedTest
    @CsvSource({"1, 0.3, 1.5", "1, 0.6, 1.5", "1, 1, 1.5", "0, 0.3, 1.5", "0, 0.5, 1.8", "0, 1, 1", "0.4, 0.45, 2.4"})
    void importedSurface_isShadedAsInTheSpecification(double metallic, double roughness, double ior) throws Exception {
        double[] base = {0.9, 0.5, 0.1};
        ImportedScene imported =
                importJson(surface(
                        "'baseColorFactor': [0.9, 0.5, 0.1, 1], 'metallicFactor': " + metallic + ", 'roughnessFactor': " + roughness)
                        .replace("}}", "}, 'extensions': {'KHR_materials_ior': {'ior': " + ior + "}}}"));
        imported.write();
        Film film =
                new ReferenceTracer(
                        JenReader.read(folder.resolve("a.jen")).scene().withPicture(imported.scene().picture().withSize(40, 30)))
                        .trace();
        double f0 = Math.pow((ior - 1) / (ior + 1), 2);
        int compared = 0;
        for (int y = 0; y < film.height(); y += 2) {
            for (int x = 0; x < film.width(); x += 2) {
                Vec3 position = visiblePoint(x, y, film.width(), film.height());
                if (position.x() > 0.01 && position.x() < 0.99 && position.y() > 0.01 && position.y() < 0.99) {
                    Vec3 toLight = BULB.minus(position);
                    double irradiance = WATTS_PER_STERADIAN / toLight.dot(toLight);
                    Vec3 view = EYE.minus(position).normalized();
                    double[] albedo = albedo(view.z(), roughness);
                    float[] rendered = {film.red(x, y), film.green(x, y), film.blue(x, y)};
                    for (int c = 0; c < 3; c++) {
                        double expected =
                                irradiance * specifiedBrdf(base[c], metallic, roughness, f0, new Vec3(0, 0, 1), toLight.normalized(), view,
                                        albedo);
                        assertThat((double) rendered[c]).as("channel %d of pixel %d, %d", c, x, y)
                                .isCloseTo(expected, within(expected * (TABLE_ERROR + 32 * 0x1p-24 / (roughness * roughness))));
                    }
                    compared++;
                }
            }
        }
        assertThat(compared).isGreaterThan(75);
    }

    /** Returns where the center of a pixel sees the square's plane. */
    private static Vec3 visiblePoint(int x, int y, int width, int height) {
        double halfHeight = Math.tan(YFOV / 2);
        double right = ((x + 0.5) / width * 2 - 1) * halfHeight * width / height;
        double up = (1 - (y + 0.5) / height * 2) * halfHeight;
        Vec3 ray = new Vec3(right, Math.sin(ROTATION) + up * Math.cos(ROTATION), -Math.cos(ROTATION) + up * Math.sin(ROTATION));
        return EYE.plus(ray.times(-EYE.z() / ray.z()));
    }

    @Test
    void missingProperties_haveFormatDefaults() throws Exception {
        Material material = material("{}");
        assertThat(material.model()).isEqualTo(ShadingModel.PRINCIPLED);
        assertThat(material.base()).isEqualTo(Rgb.WHITE);
        assertThat(material.metalness()).isEqualTo(1);
        assertThat(material.roughness()).isEqualTo(1);
        assertThat(material.f0()).isEqualTo(0.04);
    }

    /** Most files contain a factor of 1 1 1 and emit by the texture. */
    @Test
    void emissiveTexture_isGlowMap() throws Exception {
        ImportedScene imported = importJson("{'emissiveTexture': {'index': 0}, 'emissiveFactor': [1, 0.5, 1]}");
        imported.write();
        Material glowing = JenReader.read(folder.resolve("a.jen")).scene().materials().getFirst();
        assertThat(glowing.glow()).isEqualTo(new Rgb(1, 0.5, 1).times(1 / 683.0));
        assertThat(glowing.glowMap().orElseThrow().image().channel(0, 0, 1)).isEqualTo((float) SrgbCurve.toLinear(192 / 255.0),
                within(1e-6f));
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("emissiveTexture"));
    }

    @Test
    void emissiveTextureOfBlackFactor_isLeftOut() throws Exception {
        ImportedScene imported = importJson("{'emissiveTexture': {'index': 0}}");
        assertThat(imported.scene().materials().getFirst().glow()).isEqualTo(Rgb.BLACK);
        assertThat(imported.scene().materials().getFirst().glowMap()).isEmpty();
    }

    @Test
    void emissiveTextureWithAnotherPlacement_isNoted() throws Exception {
        ImportedScene imported = importJson("{'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}},"
                + " 'emissiveTexture': {'index': 0, 'texCoord': 1}, 'emissiveFactor': [1, 1, 1]}");
        assertThat(imported.notes()).containsEntry(
                "emissiveTexture of materials with texture coordinates of its own, placed like other textures",
                1);
    }

    @Test
    void unreadableEmissiveTexture_isIgnored() throws Exception {
        String broken = "{'emissiveTexture': {'index': 1}, 'emissiveFactor': [1, 1, 1]}";
        ImportedScene imported = importJson(broken, "'textures': [{'source': 0}]", "'textures': [{'source': 0}, {}]");
        assertThat(imported.scene().materials().getFirst().glow()).isEqualTo(Rgb.BLACK);
        assertThat(imported.notes()).containsEntry("emissiveTexture of materials", 1);
    }

    @Test
    void requiredTextureFormat_isReplacedByItsFactor() throws Exception {
        ImportedScene imported = importJson(surface("'baseColorTexture': {'index': 0}, 'baseColorFactor': [1, 0, 0, 1]"),
                "'textures': [{'source': 0}]",
                "'extensionsRequired': ['KHR_texture_basisu'], 'textures': [{'extensions': {'KHR_texture_basisu': {'source': 0}}}]");
        assertThat(imported.scene().materials().getFirst().base()).isEqualTo(new Rgb(1, 0, 0));
        assertThat(imported.notes().keySet()).anyMatch(note -> note.startsWith("textures in formats of extensions, such as KTX2"));
    }

    @Test
    void invalidTexture_isReplacedByItsFactor() throws Exception {
        ImportedScene imported = importJson(surface("'baseColorTexture': {'index': -1}, 'baseColorFactor': [1, 0, 0, 1]"));
        assertThat(imported.scene().materials().getFirst().base()).isEqualTo(new Rgb(1, 0, 0));
        assertThat(imported.notes()).containsEntry("textures with invalid references", 1);
    }

    @Test
    void invalidMaterial_isGray() throws Exception {
        ImportedScene imported = importJson("{'pbrMetallicRoughness': []}");
        assertThat(imported.scene().materials().getFirst().base()).isEqualTo(Rgb.gray(0.5));
        assertThat(imported.notes()).containsEntry("materials with invalid values, imported as gray", 1);
    }

    @Test
    void importedMaterial_roundTripsThroughJen() throws Exception {
        ImportedScene imported =
                importJson(surface(
                        "'baseColorFactor': [0.1, 0.2, 0.30000001192092896, 1], 'metallicFactor': 0.7, 'roughnessFactor': 0.123456789")
                        .replace("}}", "}, 'emissiveFactor': [0, 0.5, 1]}"));
        imported.write();
        assertThat(JenReader.read(folder.resolve("a.jen")).scene().materials()).isEqualTo(imported.scene().materials());
        assertThat(imported.scene().materials().getFirst().glow()).isEqualTo(new Rgb(0, 0.5, 1).times(1 / 683.0));
        assertThat(imported.scene().materials().getFirst().ambient()).isEqualTo(Rgb.BLACK);
    }

    @Test
    void specularAndIor_setReflectance() throws Exception {
        String plastic = "{'pbrMetallicRoughness': {'metallicFactor': 0}, 'extensions': {'KHR_materials_ior': {'ior': 3},"
                + " 'KHR_materials_specular': {'specularFactor': 0.5, 'specularColorFactor': [COLOR]}}}";
        assertThat(material(plastic.replace("COLOR", "1, 1, 1")).f0()).isEqualTo(0.125);
        assertThat(material(plastic.replace("COLOR", "8, 8, 8")).f0()).as("a surface mirrors all, half of which is left").isEqualTo(0.5);
        ImportedScene tinted = importJson(plastic.replace("COLOR", "0.5, 1, 0"));
        assertThat(tinted.scene().materials().getFirst().f0()).isEqualTo(0.125);
        assertThat(tinted.scene().materials().getFirst().specularTint()).isEqualTo(new Rgb(0.5, 1, 0));
        assertThat(tinted.notes()).containsEntry("grazing-angle specular below 1 (specularFactor), imported as 1", 1);
        assertThat(importJson(plastic.replace("COLOR", "1, 0, 0").replace("'metallicFactor': 0", "'metallicFactor': 1")).notes().keySet())
                .as("of a metal").noneMatch(note -> note.contains("specular"));
    }

    @Test
    void clearcoat_isCoat() throws Exception {
        ImportedScene imported = importJson("{'extensions': {'KHR_materials_clearcoat': {'clearcoatFactor': 0.75,"
                + " 'clearcoatRoughnessFactor': 0.25}}}");
        assertThat(imported.scene().materials().getFirst().coat()).isEqualTo(new Coat(0.75, 0.25, 1.5));
    }

    @Test
    void sheen_isSheenOfThatLobe() throws Exception {
        ImportedScene imported = importJson("{'extensions': {'KHR_materials_sheen': {'sheenColorFactor': [0, 0.5, 1],"
                + " 'sheenRoughnessFactor': 0.5}}}");
        Sheen sheen = imported.scene().materials().getFirst().sheen();
        assertThat(sheen.color()).isEqualTo(new Rgb(0, 0.5, 1));
        // A ball with the extension's lobe of this roughness sends 0.1423 of white light back; Cycles has 0.1149 at 0.5 and 0.1740 at 0.6.
        assertThat(sheen.roughness()).isCloseTo(0.5 + 0.1 * (0.1423 - 0.1149) / (0.1740 - 0.1149), within(0.012));
    }

    @Test
    void roughnessInExtrasOfSheen_isThatOfScenes() throws Exception {
        ImportedScene imported = importJson("{'extensions': {'KHR_materials_sheen': {'sheenColorFactor': [1, 1, 1],"
                + " 'sheenRoughnessFactor': 0.5, 'extras': {'roughness': 0.25}}}}");
        assertThat(imported.scene().materials().getFirst().sheen()).isEqualTo(new Sheen(Rgb.WHITE, 0.25));
    }

    /** The extension has the width α across the direction, and along it a mix of α and 1 by the square of its strength. */
    @Test
    void anisotropy_keepsBothWidths() throws Exception {
        ImportedScene imported = importJson("{'pbrMetallicRoughness': {'roughnessFactor': 0.5}, 'extensions': {'KHR_materials_anisotropy':"
                + " {'anisotropyStrength': 0.6, 'anisotropyRotation': 1.5707963267948966, 'anisotropyTexture': {'index': 0}}}}");
        Material material = imported.scene().materials().getFirst();
        Anisotropy anisotropy = material.anisotropy();
        assertThat(anisotropy.across(material.alpha())).isCloseTo(0.25, within(1e-6));
        assertThat(anisotropy.along(material.alpha())).isCloseTo(0.25 + 0.75 * 0.36, within(1e-6));
        assertThat(anisotropy.rotation()).isEqualTo(90);
        assertThat(imported.notes()).containsEntry("anisotropyTexture of materials", 1);
    }

    @Test
    void anisotropyOfScenes_keepsItsNumbers() throws Exception {
        ImportedScene imported = importJson("{'pbrMetallicRoughness': {'roughnessFactor': 0.3}, 'extensions': {'KHR_materials_anisotropy':"
                + " {'anisotropyStrength': 0.8, 'extras': {'anisotropy': 0.8}}}}");
        Material material = imported.scene().materials().getFirst();
        assertThat(material.anisotropy()).isEqualTo(new Anisotropy(0.8, 0));
        assertThat(material.roughness()).isEqualTo(0.3);
    }

    @Test
    void anisotropyOfGlass_isNoted() throws Exception {
        ImportedScene imported = importJson("{'extensions': {'KHR_materials_anisotropy': {'anisotropyStrength': 0.5},"
                + " 'KHR_materials_transmission': {'transmissionFactor': 1}},"
                + " 'pbrMetallicRoughness': {'metallicFactor': 0, 'roughnessFactor': 0.3}}");
        assertThat(imported.scene().materials().getFirst().anisotropy()).isEqualTo(Anisotropy.NONE);
        assertThat(imported.notes()).containsEntry("anisotropy of transparent materials", 1);
    }

    @Test
    void sheenOfGlass_isNoted() throws Exception {
        ImportedScene imported = importJson("{'extensions': {'KHR_materials_sheen': {'sheenColorFactor': [1, 1, 1]},"
                + " 'KHR_materials_transmission': {'transmissionFactor': 1}}, 'pbrMetallicRoughness': {'metallicFactor': 0}}");
        assertThat(imported.scene().materials().getFirst().sheen()).isEqualTo(Sheen.NONE);
        assertThat(imported.notes()).containsEntry("sheen of transparent materials", 1);
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
        "iridescence; 'iridescenceFactor': 0.5", "diffuse transmission; 'diffuseTransmissionFactor': 0.5"})
    void missingProperty_isNotedWithItsMaterial(String property, String factor) throws Exception {
        String extension = "KHR_materials_" + property.replace(' ', '_');
        ImportedScene imported = importJson("{'name': 'silk', 'extensions': {'" + extension + "': {" + factor + "}}},"
                + " {'name': 'plain', 'extensions': {'" + extension + "': {}}}", "'buffers':",
                "'extensionsUsed': ['" + extension + "'], 'buffers':");
        assertThat(imported.notes()).containsEntry(property + " of materials: 'silk'", 1);
        assertThat(imported.notes().keySet()).noneMatch(note -> note.startsWith("extensions"));
    }

    @Test
    void coatOfClearGlass_isNoted() throws Exception {
        ImportedScene imported = importJson("{'extensions': {'KHR_materials_clearcoat': {'clearcoatFactor': 1},"
                + " 'KHR_materials_transmission': {'transmissionFactor': 1}}, 'pbrMetallicRoughness': {'metallicFactor': 0, 'roughnessFactor': 0}}");
        assertThat(imported.notes()).containsEntry("coats of clear materials", 1);
    }

    @Test
    void metallicRoughnessTexture_isRoughnessInGreenAndMetalnessInBlue() throws Exception {
        ImportedScene imported = importJson(surface("'metallicFactor': 0.5, 'roughnessFactor': 0.25,"
                + " 'metallicRoughnessTexture': {'index': 0}"), "'textures': [{'source': 0}]",
                "'samplers': [{'wrapS': 33071, 'wrapT': 33648}], 'textures': [{'source': 0, 'sampler': 0}]");
        imported.write();
        Material material = JenReader.read(folder.resolve("a.jen")).scene().materials().getFirst();
        SurfaceMaps maps = material.surfaceMaps();
        assertThat(material.metalness()).isEqualTo(0.5);
        assertThat(material.roughness()).isEqualTo(0.25);
        assertThat(maps.meanRoughness()).isEqualTo(192 / 255f);
        assertThat(maps.meanMetalness()).isEqualTo(1);
        assertThat(maps.roughnessChannel()).isEqualTo(TextureChannel.GREEN);
        assertThat(maps.metalnessChannel()).isEqualTo(TextureChannel.BLUE);
        assertThat(maps.roughness().orElseThrow().wrap()).isEqualTo(new TextureWrap(Edge.CLAMP, Edge.MIRROR));
        assertThat(maps.metalness()).as("one file for both").isEqualTo(maps.roughness());
        assertThat(material.texture()).isEmpty();
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("metallicRoughnessTexture"));
    }

    @Test
    void embeddedImagesOfOneName_areDifferent() throws Exception {
        String image = "{'name': 'a', 'uri': 'data:image/png;base64,";
        ImportedScene imported = importJson(surface("'baseColorTexture': {'index': 0}, 'metallicRoughnessTexture': {'index': 1}"),
                "'textures': [{'source': 0}],\n 'images': [{'uri': 'data:image/png;base64," + PIXEL + "'}]",
                "'textures': [{'source': 0}, {'source': 1}], 'images': [" + image + PIXEL + "'}, " + image + BLACK + "'}]");
        imported.write();
        Material material = JenReader.read(folder.resolve("a.jen")).scene().materials().getFirst();
        assertThat(material.texture().orElseThrow().image().channel(0, 0, 2)).isEqualTo(1);
        assertThat(material.surfaceMaps().meanMetalness()).isZero();
    }

    @Test
    void metallicRoughnessTextureOfFrostedGlass_isMap() throws Exception {
        ImportedScene imported = importJson("{'pbrMetallicRoughness': {'metallicFactor': 0, 'roughnessFactor': 0.5,"
                + " 'metallicRoughnessTexture': {'index': 0}}, 'extensions': {'KHR_materials_transmission': {'transmissionFactor': 1}}}");
        Material glass = imported.scene().materials().getFirst();
        assertThat(glass.roughness()).isEqualTo(0.5);
        assertThat(glass.surfaceMaps().roughness()).isPresent();
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("metallicRoughnessTexture"));
    }

    @Test
    void metallicRoughnessTextureOfClearGlass_isReplacedByItsMean() throws Exception {
        ImportedScene imported = importJson("{'pbrMetallicRoughness': {'metallicFactor': 0, 'roughnessFactor': 0.09,"
                + " 'metallicRoughnessTexture': {'index': 0}}, 'extensions': {'KHR_materials_transmission': {'transmissionFactor': 1}}}");
        Material glass = imported.scene().materials().getFirst();
        assertThat(glass.roughness()).isEqualTo(0.09 * (192 / 255f));
        assertThat(glass.surfaceMaps()).isEqualTo(SurfaceMaps.NONE);
        assertThat(imported.notes()).containsEntry("metallicRoughnessTexture of materials, averaged", 1);
    }

    @Test
    void metallicRoughnessTextureWithAnotherPlacement_isNoted() throws Exception {
        String note = "metallicRoughnessTexture of materials with texture coordinates of its own, placed like other textures";
        String json = surface("'baseColorTexture': {'index': 0}, 'metallicRoughnessTexture': {'index': 0, 'texCoord': 1}");
        assertThat(importJson(json).notes()).containsEntry(note, 1);
        assertThat(importJson(json.replace("'texCoord': 1", "'texCoord': 0")).notes()).doesNotContainKey(note);
    }

    @Test
    void unreadableMetallicRoughnessTexture_isNotedAndFactorsStay() throws Exception {
        String json = GltfFixtures.SQUARE_JSON.replace("'buffers':", """
                'textures': [{'source': 0}], 'images': [{'uri': 'data:image/png;base64,AAAA'}],
                'materials': [{'pbrMetallicRoughness': {'metallicFactor': 0.5, 'metallicRoughnessTexture': {'index': 0}}}], 'buffers':""");
        ImportedScene imported = SceneImporter.read(Files.write(folder.resolve("a.glb"), GltfFixtures.binary(json, GltfFixtures.SQUARE)),
                folder.resolve("a.jen"),
                LightUnits.CANDELA, Progress.NONE);
        assertThat(imported.scene().materials().getFirst().metalness()).isEqualTo(0.5);
        assertThat(imported.scene().materials().getFirst().surfaceMaps()).isEqualTo(SurfaceMaps.NONE);
        assertThat(imported.notes()).containsEntry("metallicRoughnessTexture of materials", 1);
    }

    @Test
    void specularGlossiness_isNotMetallic() throws Exception {
        Material material = material("{'extensions': {'KHR_materials_pbrSpecularGlossiness': {'diffuseFactor': [0.1, 0.2, 0.3, 1],"
                + " 'specularFactor': [0.2, 0.2, 0.2], 'glossinessFactor': 0.75}}}");
        assertThat(material.base()).isEqualTo(new Rgb(0.1, 0.2, 0.3));
        assertThat(material.metalness()).isZero();
        assertThat(material.roughness()).isEqualTo(0.25);
        assertThat(material.f0()).isEqualTo(0.2);
    }

    @Test
    void thicknessTexture_isNoted() throws Exception {
        assertThat(importJson("{'extensions': {'KHR_materials_volume': {'thicknessFactor': 1, 'thicknessTexture': {'index': 0}}}}").notes())
                .containsEntry("thicknessTexture of materials", 1);
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';',
            value = {"'texCoord': 1; 1", "'extensions': {'KHR_texture_transform': {'scale': [2, 2]}}; 0",
                "'extensions': {'KHR_texture_transform': {'texCoord': 1}}; 1", "'texCoord': 0; 0"})
    void differentlyPlacedNormalMap_isNoted(String placement, int noteCount) throws Exception {
        ImportedScene imported =
                importJson("{'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}}, 'normalTexture': {'index': 0, PLACED}}"
                        .replace("PLACED", placement));
        assertThat(
                imported.notes()
                        .getOrDefault("normalTexture of materials with other texture coordinates than baseColorTexture, placed like it", 0))
                .isEqualTo(noteCount);
    }

    /** The image of a point (u, v), v downwards, is at (0.25 + 2 v, 0.5 − 3 u) by the extension's rotation by a quarter. */
    @Test
    void texturesOfOneMaterial_haveTheirOwnPlacements() throws Exception {
        ImportedScene imported =
                importJson("{'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}, 'metallicRoughnessTexture': {'index': 0,"
                        + " 'extensions': {'KHR_texture_transform': {'offset': [0.25, 0.5], 'rotation': 1.5707963267948966, 'scale': [3, 2]}}}}}");
        Material material = imported.scene().materials().getFirst();
        assertThat(material.texture().orElseThrow().placement()).isEqualTo(TexturePlacement.NONE);
        TextureMap map = material.surfaceMaps().roughness().orElseThrow();
        TexturePlacement placement = map.placement();
        for (double[] point : new double[][] {{0, 0}, {0.25, 0.125}, {0.75, 0.5}}) {
            double u = map.repeatU() * point[0];
            double v = map.repeatV() * (1 - point[1]);
            double imageU = placement.cosine() * u - placement.sine() * v + placement.offsetU();
            double imageV = placement.sine() * u + placement.cosine() * v + placement.offsetV();
            assertThat(Math.IEEEremainder(imageU - (0.25 + 2 * point[1]), 1)).isCloseTo(0, within(1e-6));
            assertThat(Math.IEEEremainder(1 - imageV - (0.5 - 3 * point[0]), 1)).isCloseTo(0, within(1e-6));
        }
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("plac"));
    }

    @Test
    void unlitMaterial_showsOnlyItsColor() throws IOException, MeshException, JenException {
        Material material =
                material("{'pbrMetallicRoughness': {'baseColorFactor': [0.1, 0.2, 0.3, 1]}, 'extensions': {'KHR_materials_unlit': {}}}");
        assertThat(Map.of(material.ambient(), material.diffuse())).containsEntry(new Rgb(0.1, 0.2, 0.3), Rgb.BLACK);
    }

    @Test
    void glass_hasTheTransmissionOfTheFile() throws Exception {
        Material glass = material("""
                {'pbrMetallicRoughness': {'baseColorFactor': [0.8, 0.5, 0.25, 1], 'metallicFactor': 0, 'roughnessFactor': 0},
                 'extensions': {'KHR_materials_transmission': {'transmissionFactor': 0.5}, 'KHR_materials_ior': {'ior': 1.33},
                   'KHR_materials_volume': {'thicknessFactor': 1, 'attenuationColor': [1, 0.5, 0.25], 'attenuationDistance': 3}}}""");
        assertThat(glass.transmission()).isEqualTo(new Transmission(new Rgb(0.4, 0.25, 0.125), 1.33, false, new Rgb(1, 0.5, 0.25), 3,
                ShadowCasting.TINTED));
        // Its most transparent channel transmits 0.4, so 0.6 of this is half of the file's value.
        assertThat(glass.base().times(0.6).r()).isCloseTo(0.4, within(1e-15));
        assertThat(glass.base().times(0.6).b()).isCloseTo(0.125, within(1e-15));
    }

    @Test
    void glassWithoutThickness_isThin() throws Exception {
        Material pane = material("""
                {'pbrMetallicRoughness': {'metallicFactor': 0},
                 'extensions': {'KHR_materials_transmission': {'transmissionFactor': 1}}}""");
        assertThat(pane.transmission()).isEqualTo(Transmission.NONE.withColor(Rgb.WHITE).withThin(true).withShadows(ShadowCasting.TINTED));
        assertThat(pane.base()).isEqualTo(Rgb.BLACK);
    }

    @Test
    void metal_isOpaque() throws Exception {
        assertThat(material("{'extensions': {'KHR_materials_transmission': {'transmissionFactor': 1}}}").transmission())
                .isEqualTo(Transmission.NONE);
    }

    /** Unlit veil over a background of 1, so that its own color is black. */
    @Test
    void blendedMaterial_showsBackgroundByItsOpacity() throws Exception {
        ImportedScene imported =
                importJson(
                        """
                                {'alphaMode': 'BLEND', 'pbrMetallicRoughness': {'baseColorFactor': [1, 1, 1, 0.25], 'metallicFactor': 0, 'roughnessFactor': 1}}
                                """);
        imported.write();
        Scene scene = JenReader.read(folder.resolve("a.jen")).scene();
        Film film = new ReferenceTracer(scene.withLights(List.of()).withWorld(scene.world().withBackground(Rgb.WHITE))
                .withPicture(scene.picture().withSize(9, 9))).trace();
        assertThat(film.red(4, 4)).isEqualTo(0.75f);
        assertThat(scene.materials().getFirst().base()).isEqualTo(Rgb.WHITE);
    }

    private ImportedScene masked(String material, double alpha, int type) throws Exception {
        var image = new BufferedImage(2, 1, type);
        image.setRGB(0, 0, 0xFFFFFFFF);
        image.setRGB(1, 0, 0x40FFFFFF);
        var png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        String json = GltfFixtures.SQUARE_JSON.replace("'buffers':",
                "'textures': [{'source': 0}], 'images': [{'uri': 'data:image/png;base64,"
                        + Base64.getEncoder().encodeToString(png.toByteArray()) + "'}], 'materials': [{" + material
                        + "'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}, 'baseColorFactor': [1, 1, 1, " + alpha
                        + "]}}], 'buffers':");
        return SceneImporter.read(Files.write(folder.resolve("a.glb"), GltfFixtures.binary(json, GltfFixtures.SQUARE)),
                folder.resolve("a.jen"),
                LightUnits.CANDELA, Progress.NONE);
    }

    @Test
    void alphaMask_becomesCutout() throws Exception {
        ImportedScene imported = masked("'alphaMode': 'MASK', 'alphaCutoff': 0.4, ", 0.8, BufferedImage.TYPE_INT_ARGB);
        imported.write();
        Material material = JenReader.read(folder.resolve("a.jen")).scene().materials().getFirst();
        assertThat(material.cutout().cutoff()).isEqualTo(0.5);
        assertThat(material.cutout().map().orElseThrow().image().channel(0, 0, 0)).isEqualTo(1);
        assertThat(material.cutout().map().orElseThrow().image().channel(1, 0, 0)).isEqualTo(0x40 / 255f);
    }

    @Test
    void alphaMaskWithoutAlphaChannel_isIgnored() throws Exception {
        assertThat(masked("'alphaMode': 'MASK', ", 1, BufferedImage.TYPE_INT_RGB).scene().materials().getFirst().cutout())
                .isEqualTo(AlphaCutout.NONE);
        assertThat(masked("", 1, BufferedImage.TYPE_INT_ARGB).scene().materials().getFirst().cutout()).isEqualTo(AlphaCutout.NONE);
    }

    @Test
    void blendedTexture_isCutOutAtHalfAlpha() throws Exception {
        ImportedScene fading = masked("'alphaMode': 'BLEND', ", 1, BufferedImage.TYPE_INT_ARGB);
        assertThat(fading.scene().materials().getFirst().cutout().cutoff()).isEqualTo(0.5);
        assertThat(fading.scene().materials().getFirst().cutout().isActive()).isTrue();
        assertThat(fading.notes()).containsEntry("alpha-blended textures, imported as cutouts at half opacity", 1);
        ImportedScene veil = masked("'alphaMode': 'BLEND', ", 0.8, BufferedImage.TYPE_INT_ARGB);
        assertThat(veil.scene().materials().getFirst().cutout()).isEqualTo(AlphaCutout.NONE);
        assertThat(veil.scene().materials().getFirst().transmission().isTransparent()).isTrue();
    }
}
