package lightning.review.live;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.Rgb;
import lightning.render.image.ViewTransform;
import lightning.review.LightWeights;
import lightning.review.ReviewPage;
import lightning.review.ReviewView;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * A picture as pages receive it.
 *
 * @param data   JSON that names the layers, with the scene's values
 * @param layers texts of the layers by their names
 */
record LivePicture(byte[] data, Map<String, byte[]> layers) {
    /**
     * Returns the picture of layers.
     *
     * @param start        values at which the faders of a page stand in their middle
     * @param allowsEdits  whether pages may change the scene
     */
    static LivePicture of(String title, LiveLayers layers, ViewTransform view, LiveState start, boolean allowsEdits) {
        Scene base = layers.base();
        ObjectNode data = JsonNodeFactory.instance.objectNode();
        data.put("title", title).put("width", base.picture().width()).put("height", base.picture().height()).put("edits", allowsEdits);
        data.set("view", ReviewView.json(view));
        data.set("start", LiveJson.write(start));
        data.set("state", LiveJson.write(LiveState.of(layers.shown())));
        Map<String, byte[]> texts = new HashMap<>();
        ArrayNode lights = data.putArray("lights");
        for (LiveLayers.Part part : layers.parts()) {
            texts.put(part.layer().id(), part.layer().text());
            ObjectNode node = lights.addObject().put("name", part.light().name(base)).put("layer", part.layer().id());
            Light light = part.light().light(base).orElse(null);
            Rgb color = light == null ? Rgb.WHITE : light.color();
            node.put("group", light == null ? "" : light.lightGroup());
            if (light == null) {
                node.put("environment", ReviewPage.environment(part.light()));
            } else {
                ReviewPage.putWhite(light, node);
            }
            node.put("intensity", part.light().values(base).intensity() * (light == null ? 1 : LightWeights.groupIntensity(base, light)));
            ReviewPage.put(node, "color", color);
        }
        data.put("rest", layers.rest().id());
        texts.put(layers.rest().id(), layers.rest().text());
        return new LivePicture(data.toString().getBytes(StandardCharsets.UTF_8), texts);
    }

    /** Returns the start of a review with the lights and groups that it does not have yet. */
    static LiveState withNew(LiveState start, LiveState now) {
        List<LiveState.LightValue> lights = new ArrayList<>(start.lights());
        now.lights().stream().filter(l -> start.lights().stream().noneMatch(s -> s.name().equals(l.name()))).forEach(lights::add);
        List<LiveState.GroupValue> groups = new ArrayList<>(start.groups());
        now.groups().stream().filter(g -> start.groups().stream().noneMatch(s -> s.name().equals(g.name()))).forEach(groups::add);
        return new LiveState(lights, groups, start.exposure());
    }
}
