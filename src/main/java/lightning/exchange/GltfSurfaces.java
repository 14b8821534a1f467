package lightning.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import lightning.gltf.GltfMaterial;
import lightning.gltf.GltfScene;
import lightning.math.Rgb;
import lightning.mesh.MeshException;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Relief;
import lightning.scene.TextureMap;

/** Makes materials of a glTF file's. */
final class GltfSurfaces {
    private final Pieces pieces;
    private final GltfScene file;
    private final String meshFile;
    private final Map<Integer, Optional<String>> images = new HashMap<>();

    /** @param meshFile the name of the glTF file beside the scene */
    GltfSurfaces(Pieces pieces, GltfScene file, String meshFile) {
        this.pieces = pieces;
        this.file = file;
        this.meshFile = meshFile;
    }

    /**
     * The nearest that Phong's model has. A roughness r is a lobe of exponent (2 / r⁴ − 2) / 4: that of Blinn's model with the same
     * width at its top (Walter and others, Microfacet models for refraction, 2007, §5.2), a quarter for the angle to the mirrored
     * direction. Its height is that of the lobe head on, at most 1. Metals mirror as (1 − r)².
     */
    Material material(GltfMaterial m) throws IOException, MeshException {
        double metallic = Pieces.clamp(m.metallic(), 1);
        double roughness = Pieces.clamp(m.roughness(), 1);
        Rgb base = pieces.color(m.base(), 1, "base colors of materials");
        Rgb emission = pieces.color(m.emission(), Limits.MAX_EMISSION, "emission of materials");
        Material made = Material.of("material");
        if (m.unlit()) {
            made = made.withAmbient(base).withDiffuse(Rgb.BLACK);
            pieces.notes.add("textures of unlit materials", m.image() < 0 ? 0 : 1);
            return made;
        }
        double blinn = Math.min(2 / Math.pow(Math.max(roughness, 0.03), 4) - 2, 4 * Limits.MAX_SHININESS);
        double height = (blinn + 2) / 8;
        Rgb headOn = mix(m.reflection(), base, metallic);
        Rgb specular = roughness == 1 ? Rgb.BLACK
                : new Rgb(Pieces.clamp(headOn.r() * height, 1), Pieces.clamp(headOn.g() * height, 1), Pieces.clamp(headOn.b() * height, 1));
        double mirror = metallic * (1 - roughness) * (1 - roughness);
        made = made.withAmbient(emission).withDiffuse(base.times(1 - mirror)).withSpecular(specular)
                .withShininess(specular.isBlack() ? made.shininess() : Math.rint(100 * blinn / 4) / 100).withReflective(base.times(mirror));
        pieces.notes.add("metallic and rough materials, shown by Phong's model");
        return relieved(made.withTexture(picture(m.image())), m);
    }

    private static Rgb mix(Rgb a, Rgb b, double share) {
        return new Rgb(a.r() + share * (b.r() - a.r()), a.g() + share * (b.g() - a.g()), a.b() + share * (b.b() - a.b()));
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
