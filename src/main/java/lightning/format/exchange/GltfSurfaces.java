package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.format.gltf.GltfMaterial;
import lightning.format.gltf.GltfScene;
import lightning.format.jen.TextureDecoder;
import lightning.format.mesh.MeshException;
import lightning.scene.Cutout;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Relief;
import lightning.scene.SurfaceModel;
import lightning.scene.TextureMap;

/** Makes metallic materials of a glTF file's, and tells what they cannot say. */
final class GltfSurfaces {
    /** The image in a rougher surface is blurred by more than 3° to each side: there its highlight has half its height (GGX). */
    private static final double ROUGHEST_MIRROR = 0.2;

    private final Pieces pieces;
    private final GltfScene file;
    private final String meshFile;
    private final Map<Integer, Optional<String>> images = new HashMap<>();
    private final Map<Integer, SurfaceMeans> means = new HashMap<>();
    private final Map<Integer, Optional<Rgb>> glows = new HashMap<>();

    /** @param meshFile the name of the glTF file beside the scene */
    GltfSurfaces(Pieces pieces, GltfScene file, String meshFile) {
        this.pieces = pieces;
        this.file = file;
        this.meshFile = meshFile;
    }

    Material material(GltfMaterial m) throws IOException, MeshException {
        Rgb base = pieces.color(m.base(), 1, "base colours of materials");
        if (m.unlit()) {
            pieces.notes.add("textures of unlit materials", m.image() < 0 ? 0 : 1);
            return Material.of("material").withAmbient(base).withDiffuse(Rgb.BLACK);
        }
        SurfaceMeans means = m.surface() < 0 ? SurfaceMeans.NONE : means(m.surface());
        Material made = Material.of("material").withModel(SurfaceModel.METALLIC).withBase(base)
                .withAmbient(pieces.color(m.emission().times(glow(m)), Limits.MAX_EMISSION, "emission of materials"))
                .withMetalness(Pieces.clamp(m.metallic() * means.metalness(), 1))
                .withRoughness(Pieces.clamp(m.roughness() * means.roughness(), 1)).withTexture(picture(m.image()));
        return cut(relieved(clear(mirroring(highlit(made, m)), m), m), m);
    }

    /** With what a surface mirrors of lights where it is no metal: a grey share here, and all of it where it is grazed. */
    private Material highlit(Material made, GltfMaterial m) {
        Rgb head = pieces.color(m.reflection(), 1, "highlights of materials");
        boolean grey = head.min() == head.max();
        if (made.metalness() < 1) {
            pieces.notes.add("colored highlights of materials that are no metals, grey here", grey ? 0 : 1);
            pieces.notes.add("highlights of materials weakened where they are grazed, not weakened here", m.grazing() == 1 ? 0 : 1);
        }
        return made.withF0(grey ? head.r() : Math.min(head.luminance(), 1));
    }

    /**
     * With mirrored shapes where it is a metal all over and so smooth that they are sharp. Each pixel of such a surface costs as many rays as
     * the picture is deep, and {@code reflective} knows no picture, and weakens what the surface emits; so all other metals show lights alone.
     */
    private Material mirroring(Material made) {
        boolean mirrors = made.metalness() == 1 && made.roughness() <= ROUGHEST_MIRROR && made.texture().isEmpty()
                && made.ambient().isBlack();
        pieces.notes.add("metals that mirror lights alone here, being rough, in part no metal, textured or shining",
                made.metalness() > 0 && !mirrors ? 1 : 0);
        return mirrors ? made.withReflective(made.base()) : made;
    }

    /** With what is seen through it, which the base colour tints once at each surface. */
    private Material clear(Material made, GltfMaterial m) {
        var through = new SeeThrough(pieces);
        GltfMaterial.Glass glass = m.glass();
        if (!(glass.share() > 0)) {
            return through.veil(made, Pieces.clamp(m.opacity(), 1));
        }
        pieces.notes.add("materials that blur what is seen through them, sharp here", made.roughness() > ROUGHEST_MIRROR ? 1 : 0);
        Material clear = through.made(made, Pieces.clamp(glass.share(), 1), made.base(), glass.ior(), glass.thin(), made.metalness());
        double distance = glass.distance();
        return glass.thin() || !(distance <= Limits.MAX_TINT_DISTANCE) ? clear
                : clear.withClarity(clear.clarity().withTint(pieces.color(glass.tint(), 1, "colours of bodies"))
                        .withTintDistance(Math.max(distance, Limits.MIN_TINT_DISTANCE)));
    }

    /** The mean of what the emission's picture says: a factor alone would make all of the surface glow. Black where it cannot be read. */
    private Rgb glow(GltfMaterial m) throws IOException, MeshException {
        if (m.glow().isEmpty()) {
            return Rgb.WHITE;
        }
        int image = m.glow().getAsInt();
        if (!glows.containsKey(image)) {
            glows.put(image, image < 0 ? Optional.empty() : SurfaceMeans.color(file.imageBytes(image)));
        }
        Optional<Rgb> mean = glows.get(image);
        pieces.notes.add(mean.isEmpty() ? "emissiveTexture of materials" : "emissiveTexture of materials, of which the mean is taken");
        return mean.orElse(Rgb.BLACK);
    }

    /** @param image of roughness and metalness */
    private SurfaceMeans means(int image) throws IOException, MeshException {
        SurfaceMeans known = means.get(image);
        if (known == null) {
            known = SurfaceMeans.of(file.imageBytes(image)).orElse(SurfaceMeans.NONE);
            means.put(image, known);
        }
        pieces.notes.add(known == SurfaceMeans.NONE ? "metallicRoughnessTexture of materials"
                : "metallicRoughnessTexture of materials, of which the mean is taken");
        return known;
    }

    private Optional<TextureMap> picture(int image) throws IOException, MeshException {
        if (image >= 0 && !images.containsKey(image)) {
            images.put(image, image(image));
        }
        return image < 0 ? Optional.empty() : images.get(image).flatMap(Pieces::texture);
    }

    private Material relieved(Material material, GltfMaterial m) throws IOException, MeshException {
        Optional<TextureMap> normals = picture(m.normals());
        return normals.isEmpty() ? material : material.withRelief(Relief.NONE.withNormals(normals)
                .withStrength(Math.clamp(m.lean(), -Limits.MAX_STRENGTH, Limits.MAX_STRENGTH)));
    }

    /** Without what the picture's alpha says is not there. */
    private Material cut(Material material, GltfMaterial m) throws IOException, MeshException {
        if (!(m.cutoff() > 0) || material.texture().isEmpty() || !TextureDecoder.hasAlpha(file.imageBytes(m.image()))) {
            pieces.notes.add("materials that are not there by their cut-off, shown here", m.cutoff() > m.alpha() ? 1 : 0);
            return material;
        }
        pieces.notes.add("pictures that fade out, cut out here where half of them is there", m.fades() ? 1 : 0);
        return material.withCutout(new Cutout(material.texture(), Math.min(m.cutoff() / m.alpha(), 1)));
    }

    /** The name of an image's file; empty where it is none that can be shown. */
    private Optional<String> image(int image) throws IOException, MeshException {
        Optional<Path> path = file.imageFile(image);
        if (path.isPresent()) {
            if (Pieces.isPicture(path.get())) {
                return Optional.of(pieces.name(path.get()));
            }
        } else {
            byte[] bytes = file.imageBytes(image);
            if (Pieces.isPicture(bytes)) {
                String name = file.imageName(image);
                String stem = meshFile.replaceFirst("\\.[^.]*$", "") + "-" + (name.isEmpty() ? "image" + image : name);
                return Optional.of(pieces.name(stem + (bytes[1] == 'P' ? ".png" : ".jpg"), bytes));
            }
        }
        pieces.notes.add("textures that are no PNG or JPEG");
        return Optional.empty();
    }
}
