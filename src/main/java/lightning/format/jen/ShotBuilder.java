package lightning.format.jen;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.AssetSource;
import lightning.format.jen.asset.NameSuggestion;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/** Builder of the shot from its parsed block; reports conflicts with the scene. */
record ShotBuilder(TokenList tokens, ProblemList problems, Scene scene) {
    /** Returns the shot, or empty if there is none or it has problems. */
    Optional<Shot> build(List<Block> blocks) {
        Block block = blocks.stream().filter(b -> b.type == BlockTypes.SHOT).findFirst().orElse(null);
        if (block == null) {
            return Optional.empty();
        }
        List<Track> tracks = new ArrayList<>();
        Map<SceneElement<?>, Block> blocksByTarget = new HashMap<>();
        for (Block child : block.children) {
            SceneElement<?> target = target(child);
            if (!exists(child)) {
                problem(child, "there is no " + child.title() + " in the scene" + NameSuggestion.hint(child.name, scene.lights().stream()
                        .map(l -> l.name()).filter(_ -> child.type == BlockTypes.LIGHT).toList()));
            } else if (blocksByTarget.put(target, child) != null) {
                problem(child, child.title() + " must have its keys in one block, found another");
            } else {
                child.keys.stream().filter(k -> !k.keys().isEmpty()).forEach(k -> buildTrack(child, target, k).ifPresent(tracks::add));
            }
        }
        try {
            Shot shot =
                    BlockTypes.SHOT.builder().build("", new PropertyValues(block::value, AssetSource.NONE), List.of()).withTracks(tracks);
            return problems.isEmpty() ? Optional.of(shot) : Optional.empty();
        } catch (RefusalException e) {
            problem(block, "shot: " + e.getMessage());
            return Optional.empty();
        }
    }

    private Optional<Track> buildTrack(Block child, SceneElement<?> target, Block.PropertyKeys keys) {
        try {
            Track track = new Track(target, keys.property().name(), keys.keys());
            track.check(scene);
            return Optional.of(track);
        } catch (RefusalException e) {
            problems.add(tokens.start(keys.nameToken()), child.title() + ": " + e.getMessage());
            return Optional.empty();
        }
    }

    static SceneElement<?> target(Block child) {
        return child.type == BlockTypes.CAMERA ? SceneElement.CAMERA : child.type == BlockTypes.WORLD ? SceneElement.WORLD
                : child.type == BlockTypes.LIGHT ? new SceneElement.OfLight(child.name)
                : child.type == BlockTypes.LIGHT_GROUP ? new SceneElement.OfLightGroup(child.name)
                : child.type == BlockTypes.DOME ? new SceneElement.OfDome(child.name) : new SceneElement.OfNode(child.name);
    }

    private boolean exists(Block child) {
        SceneElement<?> target = target(child);
        return target.existsIn(scene) && BlockTypes.of(scene, target) == child.type;
    }

    private void problem(Block block, String message) {
        problems.add(tokens.start(block.problemToken()), message);
    }
}
