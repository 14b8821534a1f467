package lightning.editor.window.mixer;

import java.util.Locale;
import lightning.base.text.Messages;
import lightning.document.MixerChannel;
import lightning.editor.window.widget.LightTypes;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/** Filter of the mixer's strips. */
enum StripFilter {
    ALL(Messages.key("All")), SHINING(Messages.key("Active")), DARK(Messages.key("Inactive")), SOLO(Messages.key("Solo")),
    MUTED(Messages.key("Muted")),
    LIGHT_GROUPS(Messages.key("Light groups"));

    private final String title;

    StripFilter(String title) {
        this.title = title;
    }

    @Override
    public String toString() {
        return Messages.tr(title);
    }

    boolean includes(MixerChannel channel, Scene scene) {
        return switch (this) {
            case ALL -> true;
            case SHINING -> channel.isShining(scene);
            case DARK -> !channel.isShining(scene);
            case SOLO -> channel.values(scene).solo();
            case MUTED -> !channel.values(scene).on();
            case LIGHT_GROUPS -> channel instanceof MixerChannel.OfLightGroup;
        };
    }

    /** Returns whether a strip's name, light group and type contain all words of the query, ignoring case. */
    static boolean matches(String query, MixerChannel channel, Scene scene) {
        String title = channel.title(scene) + (channel instanceof MixerChannel.OfLightGroup ? Messages.tr(" light group")
                : channel.lightName().flatMap(scene::light).map(StripFilter::searchText).orElse(""));
        String text = title.toLowerCase(Locale.ROOT);
        for (String word : query.strip().toLowerCase(Locale.ROOT).split("\\s+")) {
            if (!text.contains(word)) {
                return false;
            }
        }
        return true;
    }

    private static String searchText(Light light) {
        return " " + light.lightGroup() + " " + LightTypes.title(light.type());
    }
}
