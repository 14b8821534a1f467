package lightning.format.jen;

import java.util.List;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.NameSuggestion;
import lightning.scene.Scene;

/** Values of a scene's properties in the syntax of edits: {@link PropertyEdit}. */
public final class PropertyQuery {
    private PropertyQuery() {}

    /**
     * Returns the value of a property in file syntax, such as {@code 0.4} for {@code key.intensity}.
     *
     * @param reference {@code target.property}, the part of an assignment before the equals sign
     * @throws RefusalException if it has another form, or there is no such target or property
     */
    public static String get(Scene scene, String reference) {
        PropertyEdit.Assignment parts = PropertyEdit.Assignment.of(reference + "=");
        BlockContent content = content(scene, parts.target());
        if (!content.values().containsKey(parts.property())) {
            throw new RefusalException(Quote.of(parts.target()) + " has no property " + Quote.of(parts.property())
                    + NameSuggestion.hint(parts.property(), List.copyOf(content.values().keySet())));
        }
        return PropertyEdit.text(content, parts.property());
    }

    private static BlockContent content(Scene scene, String target) {
        return switch (target) {
            case PropertyEdit.PICTURE -> BlockContent.of(BlockTypes.PICTURE, scene.picture());
            case PropertyEdit.INDIRECT -> BlockContent.of(BlockTypes.INDIRECT, scene.picture().indirect().orElseThrow(
                    () -> new RefusalException("the scene has no indirect light")));
            case PropertyEdit.CAMERA -> BlockContent.of(BlockTypes.CAMERA, scene.camera());
            case PropertyEdit.WORLD -> BlockContent.of(BlockTypes.WORLD, scene.world());
            default -> target.startsWith(PropertyEdit.DOME) ? dome(scene, NameSyntax.parse(target.substring(PropertyEdit.DOME.length())))
                    : target.startsWith(PropertyEdit.MATERIAL)
                            ? material(scene, NameSyntax.parse(target.substring(PropertyEdit.MATERIAL.length())))
                    : named(scene, NameSyntax.parse(target));
        };
    }

    private static BlockContent named(Scene scene, String name) {
        return scene.light(name).map(BlockContent::of)
                .or(() -> scene.rig().lightGroup(name).map(BlockContent::of))
                .or(() -> scene.world().dome(name).map(BlockContent::of))
                .or(() -> scene.stage().node(name).map(BlockContent::of))
                .orElseGet(() -> material(scene, name));
    }

    private static BlockContent dome(Scene scene, String name) {
        return scene.world().dome(name).map(BlockContent::of)
                .orElseThrow(() -> new RefusalException("there is no dome " + Quote.of(name)));
    }

    private static BlockContent material(Scene scene, String name) {
        return scene.material(name).map(BlockContent::of)
                .orElseThrow(() -> new RefusalException("there is no light, light group, object or material " + Quote.of(name)));
    }
}
