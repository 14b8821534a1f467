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
     * @throws IllegalArgumentException if it has another form, or there is no such target or property
     */
    public static String get(Scene scene, String reference) {
        PropertyEdit.Assignment parts = PropertyEdit.Assignment.of(reference + "=");
        BlockContent content = BlockContent.of(scene, PropertyEdit.element(scene, parts.target()));
        if (!content.values().containsKey(parts.property())) {
            throw new RefusalException(Quote.of(parts.target()) + " has no property " + Quote.of(parts.property())
                    + NameSuggestion.hint(parts.property(), List.copyOf(content.values().keySet())));
        }
        return PropertyEdit.text(content, parts.property());
    }
}
