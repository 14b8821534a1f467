package lightning.app.traced;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.ToggleGroup;
import lightning.app.model.EditorModel;
import lightning.effects.Effect;
import lightning.effects.ViewEffects;
import lightning.image.DisplayCurve;

/** The choices of how the traced picture is looked at, none of which is a part of the scene. */
public final class ViewItems {
    private ViewItems() {}

    /** @param prefix of the items' ids, which end in {@code srgb}, {@code 1998}, {@code shadows} … */
    public static List<MenuItem> of(EditorModel model, String prefix) {
        var curves = new ToggleGroup();
        return List.of(curve(model, curves, prefix + "-srgb", "sRGB", DisplayCurve.SRGB),
                curve(model, curves, prefix + "-1998", "As Computed in 1998 (Linear)", DisplayCurve.LINEAR),
                new SeparatorMenuItem(),
                effect(model, prefix + "-shadows", "Shadows", e -> e.shows(Effect.SHADOWS),
                        (e, on) -> e.with(Effect.SHADOWS, on)),
                effect(model, prefix + "-reflections", "Reflections", e -> e.shows(Effect.REFLECTION),
                        (e, on) -> e.with(Effect.REFLECTION, on)),
                effect(model, prefix + "-textures", "Light on Textures", ViewEffects::litTextures,
                        ViewEffects::withLitTextures));
    }

    private static MenuItem curve(EditorModel model, ToggleGroup group, String id, String title, DisplayCurve curve) {
        var item = new RadioMenuItem(title);
        item.setId(id);
        item.setToggleGroup(group);
        item.setOnAction(_ -> model.viewProperty().set(model.viewProperty().get().withCurve(curve)));
        model.viewProperty().subscribe(v -> item.setSelected(v.curve() == curve));
        return item;
    }

    private static MenuItem effect(EditorModel model, String id, String title, Predicate<ViewEffects> shown,
            BiFunction<ViewEffects, Boolean, ViewEffects> with) {
        var item = new CheckMenuItem(title);
        item.setId(id);
        var effects = model.look().effectsProperty();
        item.selectedProperty().addListener((_, _, on) -> effects.set(with.apply(effects.get(), on)));
        effects.subscribe(e -> item.setSelected(shown.test(e)));
        return item;
    }
}
