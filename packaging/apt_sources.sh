# Sourced by packaging/setup and packaging/test-install: where this machine's apt gets its packages from.

# apt_sources TYPE WANTED: lines of a sources.list of TYPE (deb, deb-src) for what the machine's own entries name, in
# whatever style (deb822 or one-line), with their keyrings. WANTED is asked "SITE SUITE COMPONENT" and fails for what is
# not wanted.
apt_sources() {
  local type=$1 wanted=$2 site suite component entry keyring
  apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT) $(SOURCESENTRY)' 'Created-By: Packages' | sort -u |
    while read -r site suite component entry; do
      "$wanted" "$site" "$suite" "$component" || continue
      keyring=$(sed -n -E 's/^[Ss]igned-[Bb]y:[[:space:]]*(\/[^[:space:],]+).*/\1/p
        s/.*signed-by=(\/[^],[:space:]]+).*/\1/p' "${entry%%:*}" | head -n 1)
      echo "$type ${keyring:+[signed-by=$keyring] }$site $suite $component"
    done
}
