# The Python package and its command. docker build -t brinell . && docker run --rm -v "$PWD:/work" brinell run case.toml
FROM debian:12 AS tools
RUN apt-get update && apt-get install -y --no-install-recommends \
  build-essential cmake ninja-build pkg-config python3-dev python3-venv \
  libeigen3-dev libtomlplusplus-dev libcli11-dev libfmt-dev libhdf5-dev zlib1g-dev libxxhash-dev nlohmann-json3-dev \
  && rm -rf /var/lib/apt/lists/*

FROM tools AS build
COPY . /source
# Empty: for any x86-64 or ARM processor. x86-64-v3 is faster where there is AVX2.
ARG ARCH=
RUN python3 -m venv /opt/brinell && BRINELL_ARCH="$ARCH" /opt/brinell/bin/pip install --no-cache-dir -v "/source[all]"

# What runs needs no compiler.
FROM debian:12
RUN apt-get update && apt-get install -y --no-install-recommends \
  python3 libhdf5-103-1 zlib1g libtomlplusplus3 libfmt9 libgomp1 \
  && rm -rf /var/lib/apt/lists/*
COPY --from=build /opt/brinell /opt/brinell
ENV PATH=/opt/brinell/bin:$PATH
WORKDIR /work
ENTRYPOINT ["brinell"]
