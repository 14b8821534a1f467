package lightning.review;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.render.match.LightFactor;
import lightning.render.match.MatchedScene;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.ViewSettings;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.value.SceneLimits;

/**
 * A scene with the changes of a review. Lights get the intensities and colors that the reviewer saw, whatever they are now; groups,
 * environments and the exposure change from what they are now.
 *
 * @param notes one sentence for each change that was left out
 */
public record ReviewedScene(Scene scene, List<String> notes) {

    /** Returns a scene as a review asks for it. */
    public static ReviewedScene of(Scene scene, Review review) {
        List<String> notes = new ArrayList<>();
        Scene changed = scene;
        for (Review.LightChange change : review.lights()) {
            List<Contribution> parts = change.in(changed);
            if (parts.isEmpty()) {
                notes.add(Messages.tr("there is no light {0} any more; its change was left out", Quote.of(change.light().title(changed))));
            }
            for (Contribution part : parts) {
                Optional<Light> light = part.light(changed);
                changed = light.isPresent() ? changed.withLight(changed(light.get(), change)) : changed(changed, part, change);
            }
        }
        for (Review.GroupChange change : review.groups()) {
            Optional<LightGroup> group = changed.rig().lightGroup(change.name());
            if (group.isPresent()) {
                changed = changed.withRig(changed.rig().with(changed(group.get(), change)));
            } else {
                notes.add(Messages.tr("there is no light group {0} any more; its change was left out", Quote.of(change.name())));
            }
        }
        ViewSettings view = changed.picture().view();
        double exposure = Math.clamp(view.exposure() + review.exposure(), -ViewSettings.MAX_EXPOSURE, ViewSettings.MAX_EXPOSURE);
        return new ReviewedScene(changed.withPicture(changed.picture().withView(view.withExposure(exposure))), List.copyOf(notes));
    }

    private static Light changed(Light light, Review.LightChange change) {
        Light shown = light.withColor(change.color().isEmpty() ? light.color() : limited(color(change.color())))
                .withIntensity(Math.min(change.intensity(), SceneLimits.MAX_INTENSITY / light.maxFactor()));
        double factor = Math.pow(2, change.stops().orElse(0.0));
        List<Double> tint = change.tint();
        boolean isOn = !change.mute() && change.stops().isPresent();
        return MatchedScene
                .multiplied(shown,
                        new LightFactor(Contribution.of(light), factor * tint.get(0), factor * tint.get(1), factor * tint.get(2)))
                .withOn(isOn).withSolo(change.solo());
    }

    private static Rgb color(List<Double> channels) {
        return new Rgb(channels.get(0), channels.get(1), channels.get(2));
    }

    private static Rgb limited(Rgb color) {
        return color.max() > 1 ? color.times(1 / color.max()) : color;
    }

    private static Scene changed(Scene scene, Contribution environment, Review.LightChange change) {
        boolean isOn = !change.mute() && change.stops().isPresent();
        double factor = isOn ? Math.pow(2, change.stops().orElseThrow()) : 0;
        return environment.with(scene,
                v -> v.withIntensity(Math.min(v.intensity() * factor, environment.maxIntensity())).withSolo(change.solo()));
    }

    private static LightGroup changed(LightGroup group, Review.GroupChange change) {
        double intensity = group.intensity() * Math.pow(2, change.stops().orElse(0.0));
        return group.withIntensity(Math.min(intensity, SceneLimits.MAX_GROUP_INTENSITY))
                .withOn(!change.mute() && change.stops().isPresent())
                .withSolo(change.solo());
    }
}
