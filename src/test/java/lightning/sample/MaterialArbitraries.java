package lightning.sample;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Bulb;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Coat;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Sheen;
import lightning.scene.material.SurfaceMaps;
import lightning.scene.material.Transmission;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** Arbitrary materials: matte and glossy, glowing and not, reflective and black, plain and textured. */
final class MaterialArbitraries {
    /** Images besides those that {@link #phong}, {@link #metallic}, {@link #principled} and {@link #cutouts} set. */
    private static final List<MaterialAttribute<Optional<TextureMap>>> OTHER_MAPS = MaterialAttribute.MAPS.stream()
            .filter(map -> !List
                    .of(MaterialAttribute.TEXTURE, MaterialAttribute.CUTOUT, MaterialAttribute.BUMP, MaterialAttribute.NORMAL_MAP,
                            MaterialAttribute.ROUGHNESS_MAP, MaterialAttribute.METALNESS_MAP, MaterialAttribute.F0_MAP,
                            MaterialAttribute.SPECULAR_TINT_MAP, MaterialAttribute.COAT_MAP, MaterialAttribute.COAT_ROUGHNESS_MAP,
                            MaterialAttribute.COAT_NORMAL_MAP, MaterialAttribute.SHEEN_MAP, MaterialAttribute.SHEEN_ROUGHNESS_MAP)
                    .contains(map))
            .toList();

    private MaterialArbitraries() {}

    static Arbitrary<Material> materials(String name) {
        Arbitrary<Material> opaque =
                Arbitraries.frequencyOf(Tuple.of(8, phong(name)), Tuple.of(3, metallic(name)), Tuple.of(2, principled(name)));
        return Combinators.combine(opaque, transmissions(), cutouts(), glows(), textures().list().ofSize(OTHER_MAPS.size()), bulbs())
                .as((material, clarity, cutout, glow, maps, bulb) -> withOtherMaps(material, maps)
                        .withTransmission(clarity).withCutout(cutout).withGlow(glow).withBulb(bulb));
    }

    private static Material withOtherMaps(Material material, List<Optional<TextureMap>> maps) {
        Material result = material;
        for (int i = 0; i < OTHER_MAPS.size(); i++) {
            result = OTHER_MAPS.get(i).with(result, maps.get(i));
        }
        return result;
    }

    /** Returns bulbs of lights that scenes may have, three of four none. */
    static Arbitrary<Bulb> bulbs() {
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(Bulb.NONE)), Tuple.of(1, Combinators
                .combine(bulbLights(), NumberArbitraries.rangeOrSpecial(-4, 1, 0.0, 20.0))
                .as((light, exposure) -> Bulb.NONE.withLight(light).withExposure(exposure))));
    }

    /** Returns names of lights that scenes may have, or none. */
    static Arbitrary<String> bulbLights() {
        return Arbitraries.of("", "l0", "l1", "l2", StudioScene.KEY);
    }

    private static Arbitrary<Material> metallic(String name) {
        return Combinators
                .combine(ambient(), NumberArbitraries.colors(), unitValues(), roughness(), unitValues(), colorsOrBlack(), textures(),
                        bumpMappings())
                .as((ambient, base, metalness, roughness, f0, reflective, texture, relief) -> Material.of(name)
                        .withModel(ShadingModel.METALLIC)
                        .withAmbient(ambient).withBase(base).withMetalness(metalness).withRoughness(roughness).withF0(f0)
                        .withReflective(reflective).withTexture(texture).withBumpMapping(relief));
    }

    private static Arbitrary<Material> principled(String name) {
        return Combinators.combine(metallic(name), colorsOrWhite(), anisotropies(), coats(), sheens(), surfaceMaps(), layerMaps())
                .as((material, tint, anisotropy, coat, sheen, maps, layers) -> material.withModel(ShadingModel.PRINCIPLED)
                        .withSpecularTint(tint).withAnisotropy(anisotropy).withCoat(coat).withSheen(sheen)
                        .withSurfaceMaps(maps).withLayerMaps(layers));
    }

    /** Returns none in half of the cases. */
    private static Arbitrary<SurfaceMaps> surfaceMaps() {
        Arbitrary<TextureChannel> channels = Arbitraries.of(TextureChannel.class);
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(SurfaceMaps.NONE)), Tuple.of(1, Combinators
                .combine(mostMaps(), channels, mostMaps(), channels, mostMaps(), channels, mostMaps()).as(SurfaceMaps::new)));
    }

    /** Returns none in half of the cases. */
    private static Arbitrary<LayerMaps> layerMaps() {
        Arbitrary<TextureChannel> channels = Arbitraries.of(TextureChannel.class);
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(LayerMaps.NONE)), Tuple.of(1, Combinators
                .combine(mostMaps(), channels, mostMaps(), channels, textures(), mostMaps(), mostMaps(), channels)
                .as((coat, coatChannel, rough, roughChannel, normal, sheen, sheenRough, sheenChannel) -> new LayerMaps(coat, coatChannel,
                        rough, roughChannel, normal, 0.75, sheen, sheenRough, sheenChannel))));
    }

    /** Returns maps in three of four cases, else none. */
    private static Arbitrary<Optional<TextureMap>> mostMaps() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Optional.<TextureMap>empty())),
                Tuple.of(3, maps().map(Optional::of)));
    }

    private static Arbitrary<MaterialAttribute<Optional<TextureMap>>> principledMaps() {
        return Arbitraries.of(MaterialAttribute.ROUGHNESS_MAP, MaterialAttribute.METALNESS_MAP, MaterialAttribute.F0_MAP,
                MaterialAttribute.SPECULAR_TINT_MAP, MaterialAttribute.COAT_MAP, MaterialAttribute.COAT_ROUGHNESS_MAP,
                MaterialAttribute.COAT_NORMAL_MAP, MaterialAttribute.SHEEN_MAP, MaterialAttribute.SHEEN_ROUGHNESS_MAP);
    }

    private static Arbitrary<MaterialAttribute<TextureChannel>> channelAttributes() {
        return Arbitraries.of(MaterialAttribute.ROUGHNESS_CHANNEL, MaterialAttribute.METALNESS_CHANNEL, MaterialAttribute.F0_CHANNEL,
                MaterialAttribute.COAT_CHANNEL, MaterialAttribute.COAT_ROUGHNESS_CHANNEL, MaterialAttribute.SHEEN_ROUGHNESS_CHANNEL);
    }

    private static Arbitrary<Rgb> colorsOrWhite() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Rgb.WHITE)), Tuple.of(1, NumberArbitraries.colors()));
    }

    /** Returns none in half of the cases. */
    private static Arbitrary<Coat> coats() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Coat.NONE)),
                Tuple.of(1, Combinators.combine(unitValues(), roughness(), iors()).as(Coat::new)));
    }

    /** Returns none in half of the cases. */
    private static Arbitrary<Anisotropy> anisotropies() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Anisotropy.NONE)),
                Tuple.of(1, Combinators.combine(unitValues(), angles()).as(Anisotropy::new)));
    }

    private static Arbitrary<Double> angles() {
        return Arbitraries.of(0.0, 90.0, -30.0, 17.3, 720.5);
    }

    /** Returns none in half of the cases. */
    private static Arbitrary<Sheen> sheens() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Sheen.NONE)),
                Tuple.of(1, Combinators.combine(colorsOrWhite(), unitValues()).as(Sheen::new)));
    }

    /** Returns numbers from 0 to 1, including both ends. */
    static Arbitrary<Double> unitValues() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(0.0, 1.0, 0.04)), Tuple.of(1, NumberArbitraries.range(0, 1)));
    }

    /** Returns mostly any roughness, and values around the effective minimum. */
    static Arbitrary<Double> roughness() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(0.0, 1e-300, 0.045, 1.0)), Tuple.of(1, NumberArbitraries.range(0, 0.1)),
                Tuple.of(3, NumberArbitraries.range(0, 1)));
    }

    private static Arbitrary<Material> phong(String name) {
        return Combinators.combine(ambient(), NumberArbitraries.colors(), colorsOrBlack(), shininess(), colorsOrBlack(), textures(),
                bumpMappings()).as(
                        (ambient, diffuse, specular, shininess, reflective, texture, relief) -> Material.of(name).withAmbient(ambient)
                                .withDiffuse(diffuse).withSpecular(specular).withShininess(shininess).withReflective(reflective)
                                .withTexture(texture).withBumpMapping(relief));
    }

    /** Returns changes of colors, shininess and textures. */
    static Arbitrary<MaterialChange> changes() {
        return Arbitraries.oneOf(List.of(
                ambient().map(MaterialChange.Ambient::new),
                ambient().map(MaterialChange.Glow::new),
                Arbitraries.of(Rgb.BLACK).map(MaterialChange.Glow::new),
                otherMaps().flatMap(map -> textures().map(to -> new MaterialChange.SetAttribute<>(map, to))),
                otherMaps().flatMap(map -> maps().map(to -> new MaterialChange.SetAttribute<>(map, Optional.of(to)))),
                NumberArbitraries.colors().map(MaterialChange.Diffuse::new),
                colorsOrBlack().map(MaterialChange.Specular::new),
                colorsOrBlack().map(MaterialChange.Specular::new),
                shininess().map(MaterialChange.Shininess::new),
                shininess().map(MaterialChange.Shininess::new),
                Arbitraries.of(ShadingModel.class).map(MaterialChange.Model::new),
                NumberArbitraries.colors().map(MaterialChange.Base::new),
                unitValues().map(MaterialChange.Metalness::new),
                roughness().map(MaterialChange.Roughness::new),
                unitValues().map(MaterialChange.F0::new),
                colorsOrWhite().map(to -> new MaterialChange.SetAttribute<>(MaterialAttribute.SPECULAR_TINT, to)),
                unitValues().map(to -> new MaterialChange.SetAttribute<>(MaterialAttribute.ANISOTROPY, to)),
                angles().map(to -> new MaterialChange.SetAttribute<>(MaterialAttribute.ANISOTROPY_ROTATION, to)),
                unitValues().map(to -> new MaterialChange.SetAttribute<>(MaterialAttribute.COAT, to)),
                roughness().map(to -> new MaterialChange.SetAttribute<>(MaterialAttribute.COAT_ROUGHNESS, to)),
                iors().map(to -> new MaterialChange.SetAttribute<>(MaterialAttribute.COAT_IOR, to)),
                colorsOrBlack().map(to -> new MaterialChange.SetAttribute<>(MaterialAttribute.SHEEN, to)),
                unitValues().map(to -> new MaterialChange.SetAttribute<>(MaterialAttribute.SHEEN_ROUGHNESS, to)),
                principledMaps().flatMap(map -> mostMaps().map(to -> new MaterialChange.SetAttribute<>(map, to))),
                principledMaps().flatMap(map -> mostMaps().map(to -> new MaterialChange.SetAttribute<>(map, to))),
                channelAttributes()
                        .flatMap(channel -> Arbitraries.of(TextureChannel.class)
                                .map(to -> new MaterialChange.SetAttribute<>(channel, to))),
                colorsOrBlack().map(MaterialChange.Reflective::new),
                colorsOrBlack().map(MaterialChange.Reflective::new),
                Arbitraries.of(Rgb.BLACK).map(MaterialChange.Reflective::new),
                maps().map(Optional::of).map(MaterialChange.SetTexture::new),
                Arbitraries.of(new MaterialChange.SetTexture(Optional.empty())),
                bumpMappings().map(MaterialChange.SetBumpMapping::new),
                bumpMappings().map(MaterialChange.SetBumpMapping::new),
                Arbitraries.of(new MaterialChange.SetBumpMapping(BumpMapping.NONE)),
                transmissions().map(MaterialChange.SetTransmission::new),
                colorsOrBlack().map(MaterialChange.SetTransmissionColor::new),
                iors().map(MaterialChange.Ior::new),
                Arbitraries.of(true, false).map(MaterialChange.Thin::new),
                Combinators.combine(tints(), distances()).as(MaterialChange.Tint::new),
                Arbitraries.of(ShadowCasting.class).map(MaterialChange.Shadows::new),
                cutouts().map(MaterialChange.SetCutout::new),
                Arbitraries.of(AlphaCutout.NONE).map(MaterialChange.SetCutout::new),
                materials("any").map(MaterialChange.ReplaceMaterial::new)));
    }

    private static Arbitrary<MaterialAttribute<Optional<TextureMap>>> otherMaps() {
        return Arbitraries.of(OTHER_MAPS);
    }

    private static Arbitrary<Rgb> ambient() {
        return Arbitraries.frequencyOf(Tuple.of(6, NumberArbitraries.colors()),
                Tuple.of(1, NumberArbitraries.colors().map(c -> c.times(1e6))));
    }

    /** Returns black in half of the cases. */
    private static Arbitrary<Rgb> glows() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Rgb.BLACK)), Tuple.of(1, ambient()));
    }

    private static Arbitrary<Rgb> colorsOrBlack() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Rgb.BLACK)), Tuple.of(2, NumberArbitraries.colors()));
    }

    private static Arbitrary<Double> shininess() {
        return Arbitraries.frequencyOf(
                Tuple.of(3, Arbitraries.integers().between(1, 60).map(Integer::doubleValue).withoutEdgeCases()),
                Tuple.of(2, NumberArbitraries.range(0, 40)),
                Tuple.of(1, Arbitraries.of(0.0, 1.0, 0.5, 1e-6, 1e4, 1e6)));
    }

    private static Arbitrary<Optional<TextureMap>> textures() {
        return Arbitraries.frequencyOf(
                Tuple.of(4, Arbitraries.of(Optional.<TextureMap>empty())),
                Tuple.of(1, maps().map(Optional::of)));
    }

    /** Returns none in half of the cases, flat maps, and bumps taller than wide. */
    static Arbitrary<BumpMapping> bumpMappings() {
        Arbitrary<BumpMapping> any = Combinators.combine(textures(), heights(), textures(), heights()).as(BumpMapping::new);
        Arbitrary<BumpMapping> bumps =
                Combinators.combine(maps(), heights()).as((map, h) -> new BumpMapping(Optional.of(map), h, Optional.empty(), 1));
        Arbitrary<BumpMapping> normals =
                Combinators.combine(maps(), heights()).as((map, s) -> new BumpMapping(Optional.empty(), 1, Optional.of(map), s));
        return Arbitraries.frequencyOf(Tuple.of(4, Arbitraries.of(BumpMapping.NONE)), Tuple.of(1, any), Tuple.of(1, bumps),
                Tuple.of(1, normals));
    }

    /** Returns mostly none, else cutouts of any part of the surface. */
    static Arbitrary<AlphaCutout> cutouts() {
        Arbitrary<AlphaCutout> some =
                Combinators.combine(maps().map(Optional::of), Arbitraries.of(0.5, 0.3, 1.0, 0.0, 0.75)).as(AlphaCutout::new);
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(AlphaCutout.NONE)), Tuple.of(1, some));
    }

    /** Returns opaque ones in half of the cases. */
    static Arbitrary<Transmission> transmissions() {
        Arbitrary<Transmission> clear =
                Combinators.combine(NumberArbitraries.colors(), iors(), Arbitraries.of(true, false, false), tints(), distances(),
                        Arbitraries.of(ShadowCasting.class)).as(Transmission::new);
        return Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.of(Transmission.NONE)),
                Tuple.of(1, Arbitraries.of(Transmission.NONE.withShadows(ShadowCasting.NONE))), Tuple.of(4, clear));
    }

    /** Returns values from air to the maximum, including water, glass and diamond. */
    private static Arbitrary<Double> iors() {
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(1.0, 1.33, 1.5, 2.42, 4.0, 1 + 0x1p-50)),
                Tuple.of(1, NumberArbitraries.range(1, 4)));
    }

    private static Arbitrary<Rgb> tints() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Rgb.WHITE, Rgb.BLACK)), Tuple.of(2, NumberArbitraries.colors()));
    }

    private static Arbitrary<Double> distances() {
        return Arbitraries.of(1.0, 0.1, 5.0, 1e-9, 1e9);
    }

    private static Arbitrary<Double> heights() {
        return Arbitraries.of(0.01, 0.1, -0.1, 1.0, 0.0, 1e6, -3.7);
    }

    private static Arbitrary<TextureMap> maps() {
        return Combinators.combine(images(), repeats(), repeats(), wraps(), placements())
                .as((image, u, v, wrap, placement) -> new TextureMap("sample.png", u, v, image, wrap, placement));
    }

    private static Arbitrary<TexturePlacement> placements() {
        Arbitrary<Double> offsets = Arbitraries.of(0.0, 0.25, -0.375, 7.5);
        return Arbitraries.frequencyOf(Tuple.of(2, Arbitraries.of(TexturePlacement.NONE)),
                Tuple.of(1, Combinators.combine(offsets, offsets, Arbitraries.of(0.0, 90.0, -30.0, 180.0)).as(TexturePlacement::new)));
    }

    private static Arbitrary<TextureWrap> wraps() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(TextureWrap.REPEAT)), Tuple.of(1, Arbitraries.of(TextureWrap.ALL)));
    }

    private static Arbitrary<Double> repeats() {
        return Arbitraries.of(1.0, 2.0, -1.0, 3.7, 1e-6, 1e6);
    }

    static Arbitrary<Texture> images() {
        return Arbitraries.randomValue(random -> {
            int width = 1 + random.nextInt(4);
            int height = 1 + random.nextInt(4);
            float[] rgb = new float[3 * width * height];
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] = random.nextInt(5) / 4f;
            }
            return new Texture(width, height, rgb);
        });
    }
}
