package lightning.format.exchange;

import java.io.IOException;
import java.util.Optional;
import lightning.format.exchange.assembly.PrincipledImport;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.gltf.GltfImage;
import lightning.format.gltf.GltfMaterial;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.SurfaceMaps;
import lightning.scene.value.SceneLimits;

/** Converter of the textures of KHR_materials_specular, _clearcoat and _sheen to maps; a clear material has none. */
record GltfMapImport(SceneAssembler assembler, GltfTextures textures) {

    /** Adds the maps to a material that has the factors. */
    Material withMaps(Material material, GltfMaterial m) throws IOException, MeshException {
        if (material.model() != ShadingModel.PRINCIPLED) {
            return material;
        }
        if (material.isClear()) {
            note("specularTexture", m.specular().level(), Optional.empty());
            note("specularColorTexture", m.specular().color(), Optional.empty());
            return material;
        }
        return withSheenMaps(withCoatMaps(withSpecularMaps(material, m.specular()), m.clearcoat()), m.sheen());
    }

    private Material withSpecularMaps(Material material, GltfMaterial.Specular specular) throws IOException, MeshException {
        SurfaceMaps maps = material.surfaceMaps();
        if (material.metalness() == 1 && maps.metalness().isEmpty() || material.f0() == 0) {
            return material;
        }
        Optional<TextureMap> color = noted("specularColorTexture", specular.color(), TextureUsage.COLOR);
        return material.withSurfaceMaps(maps.withF0(textures.alpha(specular.level(), "specular", alpha -> alpha)).withSpecularTint(color));
    }

    private Material withCoatMaps(Material material, GltfMaterial.Clearcoat coat) throws IOException, MeshException {
        return !material.coat().isVisible() ? material : material.withLayerMaps(LayerMaps.NONE
                .withCoat(noted("clearcoatTexture", coat.image(), TextureUsage.DATA))
                .withCoatRoughness(coat.roughness() == 0 ? Optional.empty()
                        : noted("clearcoatRoughnessTexture", coat.roughnessImage(), TextureUsage.DATA))
                .withCoatNormal(noted("clearcoatNormalTexture", coat.normalImage(), TextureUsage.DATA))
                .withCoatStrength(Math.clamp(coat.normalScale(), -SceneLimits.MAX_STRENGTH, SceneLimits.MAX_STRENGTH)));
    }

    private Material withSheenMaps(Material material, GltfMaterial.Sheen sheen) throws IOException, MeshException {
        if (!material.sheen().isVisible()) {
            return material;
        }
        Material colored = material.withLayerMaps(
                material.layerMaps().withSheen(noted("sheenColorTexture", sheen.colorImage(), TextureUsage.COLOR)));
        Optional<TextureMap> roughness = sheen.exactRoughness().isPresent()
                ? textures.alpha(sheen.roughnessImage(), "sheen", alpha -> alpha)
                : textures.alpha(sheen.roughnessImage(), "sheen",
                        alpha -> PrincipledImport.sheenRoughness(sheen.roughness() * alpha));
        if (roughness.isEmpty()) {
            return colored;
        }
        return (sheen.exactRoughness().isPresent() ? colored : colored.withSheen(colored.sheen().withRoughness(1)))
                .withLayerMaps(colored.layerMaps().withSheenRoughness(roughness));
    }

    private Optional<TextureMap> noted(String name, GltfImage image, TextureUsage usage) throws IOException, MeshException {
        Optional<TextureMap> map = textures.map(image, usage);
        note(name, image, map);
        return map;
    }

    private void note(String name, GltfImage image, Optional<TextureMap> map) {
        assembler.notes.add(name + " of materials", image.isPresent() && map.isEmpty() ? 1 : 0);
    }
}
