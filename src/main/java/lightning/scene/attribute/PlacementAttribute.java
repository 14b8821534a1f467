package lightning.scene.attribute;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.base.text.Messages;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap;
import lightning.scene.value.SceneLimits;

/**
 * Attribute of the placement of a texture on a surface. It has no effect without the texture.
 *
 * @param <T> type of the record that has the texture
 */
public final class PlacementAttribute<T, V> extends SceneAttribute<T, V> {
    private final SceneAttribute<T, Optional<TextureMap>> texture;

    private PlacementAttribute(SceneAttribute<T, Optional<TextureMap>> texture, String name, String id, String title, ValueKind<V> kind,
            V initial, String unit, Function<TextureMap, V> get, BiFunction<TextureMap, V, TextureMap> with) {
        super(name, id, title, kind, initial, unit.isEmpty() ? "" : unit + ", needs a " + texture.name(),
                record -> texture.get(record).map(get).orElse(initial),
                (record, v) -> texture.with(record, texture.get(record).map(map -> with.apply(map, v))));
        this.texture = texture;
    }

    /**
     * Returns all attributes of a texture's placement.
     *
     * @param repeat keyword of its repetition in a file, from which those of the others follow
     */
    static <T> List<SceneAttribute<T, ?>> of(SceneAttribute<T, Optional<TextureMap>> texture, String repeat) {
        return List.of(
                new PlacementAttribute<>(texture, repeat, repeat, Messages.key("Repeat"),
                        NumericKind.pair(SceneLimits.MAX_REPEAT, 1, (_, v) -> TextureMap.checkRepeat(v.get(0), v.get(1))),
                        List.of(1.0, 1.0), "times", map -> List.of(map.repeatU(), map.repeatV()),
                        (map, v) -> map.with(m -> m.repeatU(v.get(0)).repeatV(v.get(1)))),
                new PlacementAttribute<>(texture, repeat.replace("repeat", "offset"), texture.id() + "-offset", Messages.key("Offset"),
                        NumericKind.pair(SceneLimits.MAX_REPEAT, 0.1, (_, _) -> {}), List.of(0.0, 0.0), "images",
                        map -> List.of(map.placement().offsetU(), map.placement().offsetV()),
                        (map, v) -> map.withPlacement(map.placement().with(p -> p.offsetU(v.get(0)).offsetV(v.get(1))))),
                new PlacementAttribute<>(texture, repeat.replace("repeat", "rotation"), texture.id() + "-rotation",
                        Messages.key("Rotation"), NumericKind.number(-TexturePlacement.MAX_ROTATION, TexturePlacement.MAX_ROTATION, 5), 0.0,
                        "degrees", map -> map.placement().rotation(), (map, v) -> map.withPlacement(map.placement().withRotation(v))),
                new PlacementAttribute<>(texture, repeat.replace("repeat", "wrap"), repeat.replace("repeat", "wrap"), Messages.key("Wrap"),
                        ValueKind.TextureKind.WRAP, TextureWrap.REPEAT, "", TextureMap::wrap, TextureMap::withWrap));
    }

    public SceneAttribute<T, Optional<TextureMap>> texture() {
        return texture;
    }

    @Override
    public Optional<String> inactiveReason(T record) {
        return texture.get(record).isPresent() ? Optional.empty() : Optional.of(Messages.tr("the material has no {0}", texture.title()));
    }
}
